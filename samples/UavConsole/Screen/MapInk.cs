namespace UavConsole;

/// <summary>What a character of the map shows; where several things meet, the last of these wins.</summary>
internal enum MapInk
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>A lane that is to be flown.</summary>
    Lane,

    /// <summary>The edge of the area.</summary>
    Area,

    /// <summary>The path that was flown.</summary>
    Path,

    /// <summary>The ellipse of a track.</summary>
    Ellipse,

    /// <summary>Home.</summary>
    Home,

    /// <summary>A track that is not shown yet.</summary>
    Tentative,

    /// <summary>A track of a red target.</summary>
    Red,

    /// <summary>A track of an orange target.</summary>
    Orange,

    /// <summary>A track of a blue target.</summary>
    Blue,

    /// <summary>A track of a yellow target.</summary>
    Yellow,

    /// <summary>A track of a magenta target.</summary>
    Magenta,

    /// <summary>The vehicle.</summary>
    Vehicle,

    /// <summary>Scale and north.</summary>
    Frame,
}
