using System;

namespace Rabit.Tool;

/// <summary>The command cannot go on: bad input. The message is the line that the user reads.</summary>
internal sealed class ToolException : Exception
{
    public ToolException(string message)
        : base(message)
    {
    }

    public ToolException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
