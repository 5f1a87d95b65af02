using System;

namespace Rabit.Uav.Messages;

/// <summary>How far the mission is, at least once a second. A plain value.</summary>
public struct MissionStatus
{
    /// <summary>What is being done.</summary>
    public MissionPhase Phase { get; set; }

    /// <summary>Since when, by the clock of the run.</summary>
    public TimeSpan Since { get; set; }

    /// <summary>The same for people, with names and figures.</summary>
    public string? Text { get; set; }

    /// <summary>Whether the search was given up before its end, and why; null where it was not.</summary>
    public string? Aborted { get; set; }

    /// <summary>The lanes, the area and home; null before they are known.</summary>
    public SearchPlan? Plan { get; set; }

    /// <summary>How many legs of the lanes have been flown.</summary>
    public int LanesFlown { get; set; }

    /// <summary>How much of the area has been looked at, 0 to 1.</summary>
    public double Coverage { get; set; }

    /// <summary>Tracks that had their second look.</summary>
    public int Revisits { get; set; }

    /// <summary>Whether the mission was accomplished, and why not.</summary>
    public MissionResult Result { get; set; }
}
