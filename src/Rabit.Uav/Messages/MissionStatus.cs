using System;

namespace Rabit.Uav.Messages;

/// <summary>The progress of the mission, posted at least once a second. A plain value.</summary>
/// <example>
/// <code>
/// MessageSubscriber&lt;MissionStatus&gt; mission =
///     reactor.Workspace.Subscribe&lt;MissionStatus&gt;(MessageNames.Mission);
/// if (mission.Fetch())
///     Console.WriteLine($"{mission.Value.Phase}: {mission.Value.Text}");   // "Searching: lane 2 of 4, 38.1 % seen"
/// </code>
/// </example>
public struct MissionStatus
{
    /// <summary>The phase.</summary>
    public MissionPhase Phase { get; set; }

    /// <summary>When the phase began, by the clock of the run.</summary>
    public TimeSpan Since { get; set; }

    /// <summary>What is being done, as text with names and figures.</summary>
    public string? Text { get; set; }

    /// <summary>Why the search was aborted before its end; null where it was not.</summary>
    public string? Aborted { get; set; }

    /// <summary>
    /// Who took the command away, and how ("the pilot took over: mode LOITER"); null where nothing did. It stays when
    /// the operator has the mission resumed.
    /// </summary>
    public string? TakenOver { get; set; }

    /// <summary>What became of the vehicle when the program was stopped in flight.</summary>
    public MissionStopResult StopResult { get; set; }

    /// <summary>The lanes, the area and home; null before they are known.</summary>
    public SearchPlan? Plan { get; set; }

    /// <summary>How many legs of the search have been flown.</summary>
    public int LanesFlown { get; set; }

    /// <summary>How many of them were left out at the operator's command.</summary>
    public int LanesSkipped { get; set; }

    /// <summary>
    /// Fraction of the area that the camera has seen, 0 to 1; in a group what another vehicle reports where that is
    /// more.
    /// </summary>
    public double Coverage { get; set; }

    /// <summary>Tracks that were revisited.</summary>
    public int Revisits { get; set; }

    /// <summary>What is left in the battery, and what the way home takes.</summary>
    public EnergyStatus Energy { get; set; }

    /// <summary>Tracks that were to be revisited and were not seen again.</summary>
    public int RevisitsFailed { get; set; }

    /// <summary>Tracks that were not revisited because the way or the time for that was used up.</summary>
    public int RevisitsLeftOut { get; set; }

    /// <summary>Tracks that are confirmed.</summary>
    public int TracksConfirmed { get; set; }

    /// <summary>Tracks that the operator rejected.</summary>
    public int TracksRejected { get; set; }

    /// <summary>Tracks that are tentative, or were confirmed and are lost.</summary>
    public int TracksNotConfirmed { get; set; }

    /// <summary>How far the times of the pictures are off those of the poses, as the targets show it.</summary>
    public CameraClockEstimate CameraClock { get; set; }

    /// <summary>Whether the mission was accomplished, and why not.</summary>
    public MissionResult Result { get; set; }
}
