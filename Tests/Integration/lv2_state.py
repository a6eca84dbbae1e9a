"""Saves and restores the state of an LV2 instance through LV2's C interface."""
import ctypes

Store = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_uint32, ctypes.c_void_p,
                         ctypes.c_size_t, ctypes.c_uint32, ctypes.c_uint32)
Retrieve = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint32,
                            ctypes.POINTER(ctypes.c_size_t), ctypes.POINTER(ctypes.c_uint32),
                            ctypes.POINTER(ctypes.c_uint32))
NO_FEATURES = (ctypes.c_void_p * 1)()


def method(kind):
    return ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, kind, ctypes.c_void_p, ctypes.c_uint32,
                            ctypes.c_void_p)


class Interface(ctypes.Structure):
    """LV2_State_Interface."""
    _fields_ = [("save", method(Store)), ("restore", method(Retrieve))]


def interface_of(descriptor):
    address = descriptor.contents.extension_data(b"http://lv2plug.in/ns/ext/state#interface")
    return ctypes.cast(address, ctypes.POINTER(Interface)).contents


def save(descriptor, handle):
    """Returns {key: (bytes, type, flags)}."""
    saved = {}

    def store(_, key, value, size, type_urid, flags):
        saved[key] = ctypes.string_at(value, size), type_urid, flags
        return 0
    assert interface_of(descriptor).save(handle, Store(store), None, 0, NO_FEATURES) == 0
    return saved


def restore(descriptor, handle, saved):
    buffers = {key: ctypes.create_string_buffer(value[0], len(value[0]))
               for key, value in saved.items()}

    def retrieve(_, key, size, type_urid, flags):
        if key not in saved:
            return None
        size[0], type_urid[0], flags[0] = len(saved[key][0]), *saved[key][1:]
        return ctypes.addressof(buffers[key])
    assert interface_of(descriptor).restore(handle, Retrieve(retrieve), None, 0, NO_FEATURES) == 0
