// The window's view of the user's own materials.
#pragma once

#include <string>
#include <vector>

namespace idiophone {

/// For the message thread.
class MaterialView {
public:
    virtual ~MaterialView() = default;

    /// Reads the user's materials again and returns their names. Unreadable ones are left out and
    /// reported in the status.
    virtual std::vector<std::string> readUserMaterials() = 0;
    /// The names as last read.
    virtual std::vector<std::string> userMaterialNames() const = 0;
    /// Index of the user material whose figures are in effect; −1: none.
    virtual int userMaterialIndex() const = 0;
    /// Copies a user material's figures to the custom material and selects it.
    virtual void chooseUserMaterial(int index) = 0;
};

} // namespace idiophone
