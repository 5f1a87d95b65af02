namespace Rabit.Tool;

/// <summary>The exit codes of all commands, which are those of UavConsole too.</summary>
internal static class ToolExitCode
{
    /// <summary>What was asked for was done.</summary>
    public const int Done = 0;

    /// <summary>It ran to its end, and the answer is no: nothing was found, or it was refused.</summary>
    public const int NotFound = 1;

    /// <summary>Bad input: nothing was run, or a file cannot be read or written.</summary>
    public const int BadInput = 2;

    /// <summary>Ctrl-C, by the convention of shells: 128 and the signal's number.</summary>
    public const int Interrupted = 130;
}
