namespace UavConsole.Tests;

/// <summary>Keys that never change.</summary>
internal sealed class FixedHints(string line) : IKeyHints
{
    public string Line => line;
}
