using System;
using Xunit;

namespace Rabit.Tool.Tests.Running;

/// <summary>A test that needs a pseudo-terminal, and is skipped where there is none.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class TerminalFactAttribute : FactAttribute
{
    public TerminalFactAttribute()
    {
        if (!TerminalProcess.IsPossible)
            Skip = "the program script is not installed (Debian: bsdutils)";
    }
}
