namespace UavConsole;

/// <summary>What the keys do now, for the last line of the screen.</summary>
internal interface IKeyHints
{
    /// <summary>
    /// One line for people, plain text; cut off where the terminal is narrower. Empty for none: the line stays empty,
    /// so that the screen does not jump. Read at each refresh by the thread of the view.
    /// </summary>
    string Line { get; }
}
