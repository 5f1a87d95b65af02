using System.Collections.Generic;
using System.Linq;
using Rabit.Links;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>What the command line asked for.</summary>
internal sealed class ConsoleOptions
{
    /// <summary>The configuration file; null for none. What it says of the other members is in them already.</summary>
    public ConfigFile? Config { get; init; }

    /// <summary>Links in the order given; none: the simulated search is flown.</summary>
    public IReadOnlyList<LinkUrl> Links { get; init; } = [];

    /// <summary>Plain lines instead of a live screen.</summary>
    public bool IsHeadless { get; init; }

    /// <summary>The simulation at the pace of a real flight, instead of as fast as the machine goes.</summary>
    public bool IsRealTime { get; init; }

    /// <summary>Of the simulated world.</summary>
    public long Seed { get; init; } = 1;

    /// <summary>How many targets the simulated world has.</summary>
    public int TargetCount { get; init; } = 5;

    /// <summary>How many of the targets move.</summary>
    public int MovingCount { get; init; }

    /// <summary>What the simulated camera is like.</summary>
    public SimulatedLook Look { get; init; } = new();

    /// <summary>How many simulated vehicles search together.</summary>
    public int Vehicles { get; init; } = 1;

    /// <summary>From one height layer of a group to the next; null for the default.</summary>
    public double? LayerSpacingMetres { get; init; }

    /// <summary>What the ground station of a simulated group commands, and when.</summary>
    public IReadOnlyList<ScriptedCommand> Commands { get; init; } = [];

    /// <summary>How a real vehicle searches together with others; null where it searches alone.</summary>
    public GroupOptions? Group { get; init; }

    /// <summary>What the simulated vehicle flies with.</summary>
    public SimulatedAutopilot Autopilot { get; init; }

    /// <summary>What to fly; null for the bundled mission in the simulation, and for none on a link.</summary>
    public string? MissionFile { get; init; }

    /// <summary>What named the mission, for errors: the option, or file and key.</summary>
    public string MissionOption { get; init; } = "--mission";

    /// <summary>Whether a real vehicle may be commanded.</summary>
    public bool Flies { get; init; }

    /// <summary>
    /// A folder of pictures with their times, or a file in the form of camera.json; null for none.
    /// </summary>
    public string? Camera { get; init; }

    /// <summary>Heights of the ground; null where it is taken for level.</summary>
    public string? TerrainFile { get; init; }

    /// <summary>Where the targets really are; null where that is not known.</summary>
    public string? TruthFile { get; init; }

    /// <summary>Where the summary goes as JSON; null for nowhere.</summary>
    public string? SummaryFile { get; init; }

    /// <summary>
    /// Where the report goes as HTML; null for the default of a mission, and for nowhere without one.
    /// </summary>
    public string? ReportFile { get; init; }

    /// <summary>Where the log of the run goes; null for nowhere.</summary>
    public string? LogFile { get; init; }

    /// <summary>Our MAVLink system id; null for that of the vehicle.</summary>
    public byte? SystemId { get; init; }

    /// <summary>The file of the key that live links are signed with; null for none.</summary>
    public string? SignKeyFile { get; init; }

    /// <summary>The texts of PX4's events; "fetch" to read them from the autopilot; null for none.</summary>
    public string? Px4EventsFile { get; init; }

    /// <summary>Numbers of live links that are not signed all the same.</summary>
    public IReadOnlyList<int> TrustedLinks { get; init; } = [];

    /// <summary>The checklist, and what is written to the autopilot before a flight.</summary>
    public PreflightChoices Preflight { get; init; } = new();

    /// <summary>What the operator asked for.</summary>
    public OperatorChoices Operator { get; init; } = new();

    /// <summary>What is written about the flight beside summary, report and log.</summary>
    public ReportChoices Reporting { get; init; } = new();

    /// <summary>What is recorded of the links.</summary>
    public RecordingChoices Recording { get; init; } = new();

    /// <summary>Where pictures are kept; null for nowhere.</summary>
    public KeptPictureOptions? KeptPictures { get; init; }

    /// <summary>
    /// The progress file of a flight that ended: the vehicle is asked to return if that flight abandoned it. Null for
    /// a run of its own.
    /// </summary>
    public string? AbandonedStateFile { get; init; }

    /// <summary>The live page for browsers; null for none.</summary>
    public WebChoices? Web { get; init; }

    /// <summary>The arguments as given, for the report.</summary>
    public string CommandLine { get; init; } = "UavConsole";

    public bool IsSimulated => Links.Count == 0;

    /// <summary>Whether nothing but recorded logs is played.</summary>
    public bool IsReplay => Links.Count > 0 && Links.All(l => l.Kind == LinkKind.RecordedFile);

    /// <summary>Whether a mission is flown, and so judged at the end.</summary>
    public bool FliesMission => IsSimulated || Flies;
}
