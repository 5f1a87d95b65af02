namespace UavConsole;

/// <summary>What became of a key.</summary>
internal interface IKeyAnswer
{
    /// <summary>Whether the last word is spoken.</summary>
    bool IsAnswered { get; }

    /// <summary>For the last line of the screen.</summary>
    string Text { get; }
}
