using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Reporting;
using Rabit.Uav.Simulation;
using Rabit.Vision;

namespace UavConsole;

/// <summary>What a run flies or observes: the UAV, and what is known of the world around it.</summary>
internal sealed class Flight : IDisposable
{
    private const string BundledMission = "missions/search.json";

    private readonly MavlinkSigningKey? _key;

    private Flight(UavSystem uav, string source, MavlinkSigningKey? key)
    {
        Uav = uav;
        Source = source;
        _key = key;
    }

    public UavSystem Uav { get; }

    /// <summary>For people.</summary>
    public string Source { get; }

    /// <summary>Where the targets really are; null where that is not known.</summary>
    public TargetTruth? Truth { get; private init; }

    /// <summary>Where the vehicle really is; null where only the autopilot knows. After the run.</summary>
    public Func<GeodeticPosition?> TruePosition { get; private init; } = () => null;

    /// <summary>The camera of a real vehicle; null where there is none.</summary>
    public ICamera? Camera { get; private init; }

    /// <summary>The name of the mission that is flown; null where none is.</summary>
    public string? MissionName { get; private init; }

    /// <summary>The file of the mission that is flown; null where none is.</summary>
    public MissionFile? MissionFile { get; private init; }

    /// <summary>A line that the screen always shows; null for none.</summary>
    public string? Notice { get; private init; }

    /// <exception cref="ArgumentException">Options or files are wrong; the text says what.</exception>
    /// <exception cref="LinkException">A link cannot be opened.</exception>
    public static Flight Open(ConsoleOptions options)
        => options.IsSimulated ? OpenSimulation(options) : OpenLinks(options);

    public RabitReactor CreateReactor(ReactorOptions options) => Uav.CreateReactor(options);

    public void Dispose()
    {
        Uav.Dispose();
        _key?.Dispose();
    }

    private static Flight OpenSimulation(ConsoleOptions options)
    {
        MissionFile file = ReadSimulatedMission(options);
        MissionPlan mission = file.Plan;
        var worldOptions = new SimulationOptions
        {
            Seed = options.Seed,
            TargetCount = options.TargetCount,
            Autopilot = options.Autopilot,
            Motions = SimulatedMotions.MotionsOf(options.MovingCount),
        };
        options.Look.ApplyTo(worldOptions);
        worldOptions.TakePlacesFrom(mission);
        var world = new SimulatedWorld(worldOptions);
        mission = options.Look.Declare(mission, world);
        var links = new MemoryLinkPair("vehicle");
        var time = new VirtualTime(options.Seed);
        if (options.IsRealTime)
            time.Pace = 1;
        MavlinkSigningKey? key = options.SignKeyFile is { } keyFile ? SigningKeyFile.Read(keyFile) : null;
        UavOptions uavOptions = OptionsOf(options, mission);
        uavOptions.Fusion.TargetMotions =
            uavOptions.Fusion.TargetMotions.SetItems(SimulatedMotions.Declare(mission, world));
        uavOptions.OpenLinks = [links.A];
        uavOptions.OtherManagers = [world.CreateVehicle(links.B, key)];
        uavOptions.MayCommand = true;
        uavOptions.Camera = world.CreateCamera();
        (uavOptions.Imaging.Camera, uavOptions.Imaging.Mount) = (world.CameraModel, world.CameraMount);
        uavOptions.Imaging.KeptPictures = options.KeptPictures;
        uavOptions.Seed = options.Seed;
        uavOptions.Time = time;
        uavOptions.GroundCommands = null;

        // the vehicle is new each time, and so is its memory of us
        uavOptions.Signing = key is null ? null : new SigningOptions(key);
        uavOptions.Communications.Recording = options.Recording.ToOptions(isByDefault: false, mission.Name);
        options.Preflight.ApplyTo(uavOptions, mission, isSimulated: true);
        options.Operator.ApplyTo(uavOptions.MissionControl);
        UavSystem uav = OpenSystem(uavOptions, options);
        return new Flight(uav, $"simulated flight: {mission.Name}, seed {FlightText.Number(options.Seed)}, "
            + $"{FlightText.Number(options.TargetCount)} targets"
            + (options.MovingCount > 0 ? $", {FlightText.Number(options.MovingCount)} of them moving" : string.Empty),
            key)
        {
            // Panels of colours that the mission does not search for are not its targets.
            Truth = TargetTruth.Of(world, mission.Targets),
            MissionName = mission.Name,
            MissionFile = file,
            TruePosition = () => world.PositionOf(world.Truth.Pose.Position with { Down = 0 }),
        };
    }

    /// <summary>What the simulation flies: the mission that was given, or the bundled one.</summary>
    /// <exception cref="ArgumentException">It cannot be read; the text says why.</exception>
    public static MissionFile ReadSimulatedMission(ConsoleOptions options) => ReadMission(
        options.MissionFile ?? Path.Combine(AppContext.BaseDirectory, BundledMission), options.MissionOption);

    private static Flight OpenLinks(ConsoleOptions options)
    {
        // Also where it is not flown: what is wrong with it is reported.
        MissionFile? file = options.MissionFile is { } missionFile
            ? ReadMission(missionFile, options.MissionOption)
            : null;
        MissionPlan? mission = file?.Plan;
        TargetTruth? truth = options.TruthFile is { } truthFile ? ReadTruth(truthFile) : null;
        CameraFolder? folder = options.Camera is { } path ? OpenCamera(path) : null;
        ICamera? camera = folder?.CreateCamera();
        MavlinkSigningKey? key = options.SignKeyFile is { } keyFile ? SigningKeyFile.Read(keyFile) : null;
        UavOptions uavOptions = OptionsOf(options, options.Flies ? mission : null);
        uavOptions.Links = options.Links;
        uavOptions.Terrain = options.TerrainFile is { } terrain ? TerrainFile.Read(terrain) : null;
        uavOptions.MayCommand = options.Flies;
        uavOptions.Camera = camera;
        uavOptions.Signing = key is null ? null : SigningOf(key, options);
        if (folder is not null)
            (uavOptions.Imaging.Camera, uavOptions.Imaging.Mount) = (folder.Camera, folder.Mount);
        uavOptions.Imaging.KeptPictures = options.KeptPictures;
        EventTexts.ApplyTo(uavOptions.Autopilot, options.Px4EventsFile);
        if (options.Flies)
        {
            options.Preflight.ApplyTo(uavOptions, mission!, isSimulated: false);
            options.Operator.ApplyTo(uavOptions.MissionControl);
            uavOptions.MissionControl.Group = options.Group ?? uavOptions.MissionControl.Group;
            uavOptions.Communications.SendsTargetsAsTraffic = options.Operator.SendsTargetsAsTraffic;
        }

        uavOptions.GroundCommands = options.Flies ? options.Operator.GroundCommands : null;

        uavOptions.Communications.Recording = options.IsReplay
            ? null
            : options.Recording.ToOptions(
                isByDefault: true, options.Flies ? mission!.Name : null, options.Operator.AtStart is not null);
        UavSystem uav = OpenSystem(uavOptions, options);
        string links = string.Join(", ", options.Links.Select(l => l.ToString()));
        return new Flight(
            uav, options.Flies ? $"flying {mission!.Name} over {links}" : "replaying or observing " + links, key)
        {
            Truth = truth,
            Camera = camera,
            MissionName = options.Flies ? mission!.Name : null,
            MissionFile = options.Flies ? file : null,
            Notice = options.IsReplay || options.Flies
                ? null
                : "observing only: nothing is commanded; --mission FILE --fly flies",
        };
    }

    // Those of the configuration file, and what simulated and real flights have in common.
    private static UavOptions OptionsOf(ConsoleOptions options, MissionPlan? mission)
    {
        UavOptions uavOptions = options.Config?.Options ?? new UavOptions();
        uavOptions.Subscriptions =
        [
            FlightRecorderManager.CreateSubscription(), .. WebView.SubscriptionsOf(options.Web),
        ];
        uavOptions.SystemId = options.SystemId;
        uavOptions.Mission = mission;
        return uavOptions;
    }

    private static UavSystem OpenSystem(UavOptions uavOptions, ConsoleOptions options)
    {
        options.Config?.Check(uavOptions);
        return UavSystem.Open(uavOptions);
    }

    internal static SigningOptions SigningOf(MavlinkSigningKey key, ConsoleOptions options)
    {
        int live = options.Links.Count(l => l.Kind != LinkKind.RecordedFile);
        foreach (int link in options.TrustedLinks.Where(l => l < 0 || l >= live))
            throw new ArgumentException(
                $"--trust-link {FlightText.Number(link)}: there are {FlightText.Number(live)} live links, numbered "
                    + "from 0.",
                nameof(options));
        return new SigningOptions(key)
        {
            Links = Enumerable.Range(0, live).Except(options.TrustedLinks).ToArray(),
            TimestampStore = new FileTimestampStore(options.SignKeyFile + ".clock"),
        };
    }

    private static TargetTruth ReadTruth(string path)
    {
        try
        {
            return TruthFile.Parse(TextFile.Read(path));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new ArgumentException($"--truth {path} cannot be read: {e.Message}", nameof(path), e);
        }
        catch (FormatException e)
        {
            throw new ArgumentException($"--truth {path}: {e.Message}", nameof(path), e);
        }
    }

    private static CameraFolder OpenCamera(string path)
    {
        try
        {
            return CameraFolder.Open(path);
        }
        catch (PictureException e)
        {
            throw new ArgumentException("--camera " + e.Message, nameof(path), e);
        }
    }

    private static MissionFile ReadMission(string path, string option)
    {
        MissionFile file = ParseMission(path, option);
        return file.FindFaultOfHome() is { } fault
            ? throw new ArgumentException($"{option} {path}: {fault}", nameof(path))
            : file;
    }

    private static MissionFile ParseMission(string path, string option)
    {
        try
        {
            string text = TextFile.Read(path);
            return new MissionFile(
                Path.GetFileName(path), text,
                MissionPlan.Parse(text, Path.GetFileName(path), Path.GetDirectoryName(Path.GetFullPath(path))));
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException)
        {
            throw new ArgumentException($"{option} {path} cannot be read: {e.Message}", nameof(path), e);
        }
        catch (MissionPlanException e)
        {
            throw new ArgumentException($"{option} {path}: {e.Sentence}", nameof(path), e);
        }
    }
}
