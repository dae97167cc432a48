#include "io/VtkMessages.H"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

namespace sph
{

namespace
{

class MessageCatcher : public vtkOutputWindow
{
public:
    vtkTypeMacro(MessageCatcher, vtkOutputWindow);
    static MessageCatcher* New();

    std::string text;

    void DisplayText(const char* message) override
    {
        // "ERROR: In <file>, line <n>\n<class> (<address>): <message>\n\n"
        std::string line = message ? message : "";
        const std::size_t begin = line.find("): ");
        if (begin != std::string::npos)
        {
            line.erase(0, begin + 3);
        }
        line.erase(line.find_last_not_of(" \n") + 1);

        // The pipeline repeats what its reader said, with all of its own state
        if (line.rfind("Algorithm ", 0) != 0)
        {
            text += line + '\n';
        }
    }
};

vtkStandardNewMacro(MessageCatcher);

} // namespace


VtkMessages::VtkMessages()
:
    previous_(vtkOutputWindow::GetInstance()),
    catcher_(vtkSmartPointer<MessageCatcher>::New()),
    previousVerbosity_(vtkLogger::GetCurrentVerbosityCutoff())
{
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::SetInstance(catcher_);
}

VtkMessages::~VtkMessages()
{
    vtkOutputWindow::SetInstance(previous_);
    vtkLogger::SetStderrVerbosity(vtkLogger::Verbosity(previousVerbosity_));
}

std::string VtkMessages::text() const
{
    return static_cast<MessageCatcher*>(catcher_.Get())->text;
}

} // namespace sph
