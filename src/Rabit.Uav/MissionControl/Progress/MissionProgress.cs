using System;
using System.Collections.Immutable;
using System.IO;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// How far a mission has got, as its progress file says: what is flown, what is seen, what was found, and whether we
/// commanded the vehicle in the air when it was written. Immutable.
/// </summary>
/// <example>
/// <code>
/// var options = new MissionControlOptions
/// {
///     Mission = mission,
///     Resume = MissionProgress.ReadFile("field.progress.json"),
///     ProgressFile = "field.progress.json",
/// };
/// </code>
/// </example>
public sealed class MissionProgress
{
    /// <summary>Name of the mission.</summary>
    public string MissionName { get; init; } = string.Empty;

    /// <summary>When it was written, by the computer's clock.</summary>
    public DateTimeOffset SavedUtc { get; init; }

    /// <summary>The phase then.</summary>
    public MissionPhase Phase { get; init; }

    /// <summary>Whether Mission Control commanded the vehicle then, and nothing had taken over.</summary>
    public bool IsCommanding { get; init; }

    /// <summary>Whether the vehicle was in the air then.</summary>
    public bool IsInAir { get; init; }

    /// <summary>Home; its altitude is that of the ground.</summary>
    public GeodeticPosition Home { get; init; }

    /// <summary>How many legs of the search have been flown.</summary>
    public int LanesFlown { get; init; }

    /// <summary>How many legs there are, with those that are flown.</summary>
    public int LaneCount => Legs.IsDefault ? 0 : Legs.Length;

    /// <summary>Fraction of the area that the camera has seen, 0 to 1.</summary>
    public double Coverage { get; init; }

    /// <summary>The confirmed targets.</summary>
    public ImmutableArray<MissionProgressTarget> Targets { get; init; } = [];

    /// <summary>The targets that the operator rejected; a flight that continues rejects them again.</summary>
    public ImmutableArray<MissionProgressTarget> RejectedTargets { get; init; } = [];

    /// <summary>What the operator had changed of the mission.</summary>
    internal ProgressChanges Changes { get; init; } = ProgressChanges.None;

    /// <summary>The lanes that the operator left out, relative to <see cref="Home"/>.</summary>
    internal ImmutableArray<SkippedLane> Skipped { get; init; } = [];

    /// <summary>Identifies the mission; see <see cref="MissionFingerprint"/>.</summary>
    internal string Fingerprint { get; init; } = string.Empty;

    /// <summary>Relative to <see cref="Home"/>.</summary>
    internal ImmutableArray<LaneSegment> Legs { get; init; } = [];

    internal double FlownMetresOfLeg { get; init; }

    internal int GapPasses { get; init; }

    internal CoverageCells Cells { get; init; } = CoverageCells.None;

    /// <summary>Reads a progress file.</summary>
    /// <param name="path">Its path.</param>
    /// <exception cref="MissionProgressException">
    /// It cannot be read, is not complete, or is of another version; the message names it.
    /// </exception>
    public static MissionProgress ReadFile(string path)
    {
        if (string.IsNullOrWhiteSpace(path))
            throw new ArgumentException("A path is needed.", nameof(path));
        try
        {
            if (new FileInfo(path).Length > MissionProgressFormat.MaxTextLength)
                throw new MissionProgressException(path, "it is too long to be one");
            return Parse(File.ReadAllText(path), path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new MissionProgressException(path, "it cannot be read: " + e.Message, e);
        }
    }

    /// <summary>Reads the text of a progress file.</summary>
    /// <param name="text">The text.</param>
    /// <param name="name">Name of the file, for errors.</param>
    /// <exception cref="MissionProgressException">It is not complete, or of another version.</exception>
    public static MissionProgress Parse(string text, string name)
        => MissionProgressFormat.Parse(
            text ?? throw new ArgumentNullException(nameof(text)),
            name ?? throw new ArgumentNullException(nameof(name)));
}
