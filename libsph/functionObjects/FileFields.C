#include "functionObjects/FileFields.H"

#include "io/vtkFields.H"

#include <algorithm>

namespace sph
{

void FileFields::read(const Snapshot& snapshot, Particles& particles)
{
    snapshot.read(particles);
    time_ = snapshot.name;
    there_.clear();
    const VtkFile file(snapshot.path/"granular.vtp", "");
    for (const FieldInfo& field : particles.fields())
    {
        // m and V follow from each other
        if
        (
            file.found(field.name) || field.mandatory || field.name == "V"
        )
        {
            there_.push_back(field.name);
        }
    }
    for (const word& field : needed_)
    {
        if (!has(field))
        {
            throw Error(missing(field));
        }
    }
}


bool FileFields::has(const word& field) const
{
    return std::find(there_.begin(), there_.end(), field) != there_.end();
}


std::string FileFields::missing(const word& field) const
{
    return
        "The field " + field + " was not written at time " + time_ + ": only"
        " a run can look at it\n\nFields that were written :\n\n"
      + listOfWords(there_);
}


void FileFields::need
(
    const word& field, const dictionary& dict, const word& entry
)
{
    if (!has(field))
    {
        dict.fail(entry, missing(field));
    }
    needed_.push_back(field);
}

} // namespace sph
