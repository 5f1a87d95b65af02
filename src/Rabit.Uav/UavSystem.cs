using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Communications;
using Rabit.Uav.GroundControl;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.ImageProcessing;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.SensorFusion;
using Rabit.Vision;

namespace Rabit.Uav;

/// <summary>
/// The companion computer: opens the links and makes the managers, which know nothing of each other. For one run: open
/// it, make its reactor, run that, dispose it.
/// </summary>
/// <example>
/// <code>
/// using UavSystem uav = UavSystem.Open(new UavOptions { Links = [LinkUrl.Parse("udpin:0.0.0.0:14550")] });
/// RabitReactor reactor = uav.CreateReactor(new ReactorOptions { Log = entry => Console.WriteLine(entry) });
/// reactor.Run();   // until SIGINT or SIGTERM
/// Console.WriteLine(uav.Communications.SummariseLinks()[0].Frames);
/// </code>
/// </example>
public sealed class UavSystem : IDisposable
{
    // Mission Control waits 3 s for the answer of the autopilot.
    private static readonly TimeSpan MaxStopDelay = TimeSpan.FromSeconds(4);

    private readonly UavOptions _options;
    private readonly List<IByteLink> _links = [];
    private readonly List<RecordedFile> _files = [];
    private readonly Dictionary<string, MavlinkSigningKey> _keys = []; // by file
    private readonly CommunicationsManager? _communications;
    private readonly AutopilotManager? _autopilot;
    private readonly ImageProcessingManager? _imageProcessing;
    private readonly SensorFusionManager? _sensorFusion;
    private readonly MissionControlManager? _missionControl;
    private readonly GroundCommandManager? _groundCommands;
    private readonly HealthManager? _health;

    private UavSystem(UavOptions options)
    {
        _options = options;
        try
        {
            OpenLinks();
            Time = CreateTime();
            if (options.Has(UavManagers.Communications))
                _communications = new CommunicationsManager(
                    ManagerOptions.ForCommunications(options, _links, _files, ReadLinkKeys()));
            if (options.Has(UavManagers.AutopilotInterface))
                _autopilot = new AutopilotManager(ManagerOptions.ForAutopilot(options));
            if (options.Has(UavManagers.ImageProcessing))
                _imageProcessing = new ImageProcessingManager(
                    ManagerOptions.ForImageProcessing(options), options.Camera);
            if (options.Has(UavManagers.SensorFusion))
                _sensorFusion = new SensorFusionManager(ManagerOptions.ForSensorFusion(options));
            if (options.Has(UavManagers.MissionControl))
                _missionControl = new MissionControlManager(ManagerOptions.ForMissionControl(options));
            if (ManagerOptions.HasGroundCommands(options))
                _groundCommands = new GroundCommandManager(
                    _missionControl!, options.GroundCommands!,
                    _imageProcessing is null || _sensorFusion is null ? null : FindPicture);
            if (options.MayCommand)
                CarryOnAfterFaults();
            if (options.Has(UavManagers.HealthMonitoring))
                _health = new HealthManager(
                    ManagerOptions.ForHealth(options, Time), Managers().Select(m => m.Name), LinkCount);
        }
        catch
        {
            Dispose();
            throw;
        }
    }

    /// <summary>Owns the links; counts what came in over them.</summary>
    /// <exception cref="InvalidOperationException">
    /// It was left out; see <see cref="UavOptions.Without"/>. So with the other managers.
    /// </exception>
    public CommunicationsManager Communications => Made(_communications, UavManagers.Communications);

    /// <summary>Speaks with the autopilot; knows what the flight was like.</summary>
    /// <exception cref="InvalidOperationException">It was left out.</exception>
    public AutopilotManager Autopilot => Made(_autopilot, UavManagers.AutopilotInterface);

    /// <summary>Finds targets in pictures; keeps their image chips.</summary>
    /// <exception cref="InvalidOperationException">It was left out.</exception>
    public ImageProcessingManager ImageProcessing => Made(_imageProcessing, UavManagers.ImageProcessing);

    /// <summary>Makes tracks of reports.</summary>
    /// <exception cref="InvalidOperationException">It was left out.</exception>
    public SensorFusionManager SensorFusion => Made(_sensorFusion, UavManagers.SensorFusion);

    /// <summary>Flies the mission, where there is one.</summary>
    /// <exception cref="InvalidOperationException">It was left out.</exception>
    public MissionControlManager MissionControl => Made(_missionControl, UavManagers.MissionControl);

    /// <summary>Watches all of it, and writes our heartbeat while it is true.</summary>
    /// <exception cref="InvalidOperationException">It was left out.</exception>
    public HealthManager Health => Made(_health, UavManagers.HealthMonitoring);

    /// <summary>
    /// The time to run in: real time, or, where logs are played at another speed than 1, virtual time that starts with
    /// the first stamp and is driven by the stamps, so that no time-out misjudges a fast replay and every speed gives
    /// the same.
    /// </summary>
    public RabitTime Time { get; }

    /// <summary>How many links there are; they are numbered from 0 in the order live links, recorded logs.</summary>
    public int LinkCount => _links.Count + _files.Count;

    /// <summary>Opens all links and makes the managers.</summary>
    /// <param name="options">Checked and read now.</param>
    /// <exception cref="ArgumentException">
    /// Options are out of their range or do not go together; the text names all of them.
    /// </exception>
    /// <exception cref="LinkException">
    /// A link cannot be opened, and waiting would not help; the text names it and says why. What may pass, a server
    /// that is not up or a device that is not plugged in, is tried again during the run, as is a link that breaks.
    /// </exception>
    public static UavSystem Open(UavOptions options)
    {
        if (options is null)
            throw new ArgumentNullException(nameof(options));
        options.Validate(nameof(options));
        return new UavSystem(options);
    }

    /// <summary>
    /// Makes the reactor with all managers. Where some are left out, its start names what the others miss.
    /// </summary>
    /// <param name="options">
    /// Its options; the time is set to <see cref="Time"/>. Where the vehicle may be commanded and
    /// <see cref="ReactorOptions.MaxStopDelay"/> is zero, it is set to 4 s, so that Mission Control can have the
    /// vehicle hold before the program ends.
    /// </param>
    public RabitReactor CreateReactor(ReactorOptions options)
    {
        if (options is null)
            throw new ArgumentNullException(nameof(options));
        options.Time = Time;
        if (_options.MayCommand && options.MaxStopDelay == TimeSpan.Zero)
            options.MaxStopDelay = MaxStopDelay;
        var reactor = new RabitReactor(options);
        foreach (RabitManager manager in Managers())
            reactor.Add(manager);
        if (_health is not null)
            reactor.Add(_health);
        foreach (AbsentManager absent in AbsentManagers.Of(_options.Without))
            reactor.Workspace.LeaveOut(absent);
        return reactor;
    }

    /// <summary>Closes the links. After the run.</summary>
    public void Dispose()
    {
        foreach (IByteLink link in _links)
            link.Dispose();
        foreach (RecordedFile file in _files)
            file.Dispose();
        foreach (MavlinkSigningKey key in _keys.Values)
            key.Dispose();
    }

    // An aircraft in the air is better off with managers that go on: Health Monitoring sees the fault, and Mission
    // Control returns to launch.
    private void CarryOnAfterFaults()
    {
        foreach (RabitManager manager in Managers().Except(_options.OtherManagers))
            manager.FaultPolicy = FaultPolicy.CarryOn;
    }

    // In the order of their start. Health Monitoring, which watches them, comes after them all.
    private IEnumerable<RabitManager> Managers()
        => new RabitManager?[]
            {
                _communications, _autopilot, _imageProcessing, _sensorFusion, _missionControl, _groundCommands,
            }
            .OfType<RabitManager>().Concat(_options.OtherManagers);

    private static T Made<T>(T? manager, UavManagers which)
        where T : RabitManager
        => manager
            ?? throw new InvalidOperationException(
                $"{which} was left out: {nameof(UavOptions)}.{nameof(UavOptions.Without)} has it.");

    private byte[]? FindPicture(long number, int report)
    {
        foreach (ImageChip chip in _imageProcessing!.ImageChips)
        {
            if (chip.PictureNumber == number && chip.ReportIndex == report)
                return PngPicture.Encode(new RgbPicture(chip.Width, chip.Height, chip.CopyPixels()));
        }

        return null;
    }

    private void OpenLinks()
    {
        _links.AddRange(_options.OpenLinks);
        foreach (LinkUrl url in _options.Links)
        {
            if (url.Kind == LinkKind.RecordedFile)
                _files.Add(RecordedFile.Open(url, ManagerOptions.DialectOf(_options)));
            else
                _links.Add(ReopeningLink.Open(url, _options.LinkOptions));
        }
    }

    // Links with one file share one key, and so what is known of its frames.
    private Dictionary<int, MavlinkSigningKey> ReadLinkKeys()
    {
        var keys = new Dictionary<int, MavlinkSigningKey>();
        foreach (KeyValuePair<int, LinkSettings> link in ManagerOptions.LinkSettingsOf(_options))
        {
            if (link.Value.KeyFile is not { } file)
                continue;
            if (!_keys.TryGetValue(file, out MavlinkSigningKey? key))
                _keys.Add(file, key = SigningKeyFile.Read(file));
            keys.Add(link.Key, key);
        }

        return keys;
    }

    private RabitTime CreateTime()
    {
        if (_options.Time is { } time)
            return time;
        if (_options.Speed.Equals(1))
            return new RealTime();
        long startMicroseconds = _files.Min(f => f.StartUtcMicroseconds);
        var start = new DateTimeOffset(
            DateTimeOffset.FromUnixTimeMilliseconds(0).Ticks + (startMicroseconds * 10), TimeSpan.Zero);
        return new VirtualTime(_options.Seed, start) { Pace = _options.Speed };
    }
}
