namespace UavConsole;

/// <summary>What the keys of the operator command: a vehicle, or a group of them.</summary>
internal interface IKeyCommands
{
    /// <summary>What the keys do, for the last line of the screen.</summary>
    string Hint { get; }

    /// <summary>What a number is, for the last line of the screen.</summary>
    string NumberName { get; }

    /// <summary>What may follow a number, for the last line of the screen.</summary>
    string NumberHint { get; }

    /// <summary>A key was pressed.</summary>
    /// <param name="key">Its character, a in lower case.</param>
    /// <param name="digits">The number before it; empty for none.</param>
    /// <returns>What it commands; null for a key that has no meaning.</returns>
    IKeyAnswer? Do(char key, string digits);
}
