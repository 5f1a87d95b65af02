using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Communications;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.ImageProcessing;
using Rabit.Links;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.SensorFusion;

namespace Rabit.Uav;

/// <summary>
/// The companion computer: opens the links and makes the managers, which know nothing of each other. For one run: open it, make
/// its reactor, run that, dispose it.
/// </summary>
public sealed class UavSystem : IDisposable
{
    private readonly UavOptions _options;
    private readonly List<IByteLink> _links = [];
    private readonly List<RecordedFile> _files = [];

    private UavSystem(UavOptions options)
    {
        _options = options;
        try
        {
            OpenLinks();
        }
        catch
        {
            Dispose();
            throw;
        }

        Communications = new CommunicationsManager(new CommunicationsOptions
        {
            Links = _links,
            RecordedFiles = _files,
            StopsWhenAllLinksEnd = options.IsReplay,
            Signing = options.Signing,
            Dialect = options.Dialect,
            Subscriptions = options.Subscriptions,
            VehicleMessageRoutes =
            [
                new VehicleMessageRoute<TargetReport>(new TargetReportCodec(), MessageNames.OutgoingTargetReports, MessageNames.TargetReports),
            ],
        });
        Autopilot = new AutopilotManager(new AutopilotOptions
        {
            SystemId = options.SystemId,
            ComponentId = options.ComponentId,
            RequestsRates = options.RequestsMessageRates && !options.IsReplay,
            MayCommand = options.MayCommand,
            Dialect = options.Dialect,
        });
        ImageProcessing = new ImageProcessingManager(options.Imaging, options.Camera);
        SensorFusion = new SensorFusionManager(options.Fusion);
        MissionControl = new MissionControlManager(new MissionControlOptions { Mission = options.Mission });
        if (options.MayCommand)
            CarryOnAfterFaults();
        Health = new HealthManager(options.Health, Managers().Select(m => m.Name), LinkCount);
        Time = CreateTime();
    }

    /// <summary>Owns the links; tells what came in over them.</summary>
    public CommunicationsManager Communications { get; }

    /// <summary>Speaks with the autopilot; tells what the flight was like.</summary>
    public AutopilotManager Autopilot { get; }

    /// <summary>Finds targets in pictures; keeps their cut-outs.</summary>
    public ImageProcessingManager ImageProcessing { get; }

    /// <summary>Makes tracks of reports.</summary>
    public SensorFusionManager SensorFusion { get; }

    /// <summary>Flies the mission, where there is one.</summary>
    public MissionControlManager MissionControl { get; }

    /// <summary>Watches all of it, and writes our heartbeat while it is true.</summary>
    public HealthManager Health { get; }

    /// <summary>
    /// The time to run in: real time, or, where logs are played at another speed than 1, virtual time that starts with the first stamp
    /// and is driven by the stamps, so that no time-out misjudges a fast replay and every speed gives the same.
    /// </summary>
    public RabitTime Time { get; }

    /// <summary>How many links there are; they are numbered from 0 in the order live links, recorded logs.</summary>
    public int LinkCount => _links.Count + _files.Count;

    /// <summary>Opens all links and makes the managers.</summary>
    /// <param name="options">Checked and read now.</param>
    /// <exception cref="ArgumentException">Options are out of their range or do not go together; the text names all of them.</exception>
    /// <exception cref="LinkException">A link cannot be opened; the text names it and says why.</exception>
    public static UavSystem Open(UavOptions options)
    {
        if (options is null)
            throw new ArgumentNullException(nameof(options));
        options.Validate(nameof(options));
        return new UavSystem(options);
    }

    /// <summary>Makes the reactor with all managers.</summary>
    /// <param name="options">Its options; the time is set to <see cref="Time"/>.</param>
    public RabitReactor CreateReactor(ReactorOptions options)
    {
        if (options is null)
            throw new ArgumentNullException(nameof(options));
        options.Time = Time;
        var reactor = new RabitReactor(options);
        foreach (RabitManager manager in Managers().Append(Health))
            reactor.Add(manager);
        return reactor;
    }

    /// <summary>Closes the links. After the run.</summary>
    public void Dispose()
    {
        foreach (IByteLink link in _links)
            link.Dispose();
        foreach (RecordedFile file in _files)
            file.Dispose();
    }

    // An aircraft in the air is better off with managers that go on: Health Monitoring sees the fault, and Mission Control comes home.
    private void CarryOnAfterFaults()
    {
        foreach (RabitManager manager in Managers().Except(_options.OtherManagers))
            manager.FaultPolicy = FaultPolicy.CarryOn;
    }

    // In the order of their start. Health Monitoring, which watches them, comes after them all.
    private IEnumerable<RabitManager> Managers()
        => new RabitManager[] { Communications, Autopilot, ImageProcessing, SensorFusion, MissionControl }.Concat(_options.OtherManagers);

    private void OpenLinks()
    {
        _links.AddRange(_options.OpenLinks);
        foreach (LinkUrl url in _options.Links)
        {
            if (url.Kind == LinkKind.RecordedFile)
                _files.Add(RecordedFile.Open(url, _options.Dialect));
            else
                _links.Add(LinkFactory.Open(url));
        }
    }

    private RabitTime CreateTime()
    {
        if (_options.Time is { } time)
            return time;
        if (_options.Speed.Equals(1))
            return new RealTime();
        long startMicroseconds = _files.Min(f => f.StartUtcMicroseconds);
        var start = new DateTimeOffset(DateTimeOffset.FromUnixTimeMilliseconds(0).Ticks + (startMicroseconds * 10), TimeSpan.Zero);
        return new VirtualTime(_options.Seed, start) { Pace = _options.Speed };
    }
}
