// Writes the object of a .modal file as glTF: write_glb INPUT.modal OUTPUT.glb
#include "Gltf/ObjectFile.h"

#include <iostream>

int main(int count, char** arguments) {
    if (count != 3)
        return 2;
    const auto written =
        idiophone::readObject(arguments[1]).and_then([&](const idiophone::ModalObject& object) {
            return idiophone::writeObject(object, arguments[2]);
        });
    if (!written)
        std::cerr << written.error().message << '\n';
    return written ? 0 : 1;
}
