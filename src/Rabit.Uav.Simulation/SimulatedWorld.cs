using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Simulation;

/// <summary>
/// A world to fly in, made from one seed: flat ground, wind, and a multirotor that speaks MAVLink as ArduCopter does.
/// The same seed gives the same bytes, in virtual time, if it is used in the same way at the same times.
/// </summary>
/// <example>
/// <code>
/// var world = new SimulatedWorld(new SimulationOptions { Seed = 7 });
/// var telemetry = new MemoryLinkPair("telemetry");
/// using UavSystem uav = UavSystem.Open(new UavOptions
/// {
///     OpenLinks = [telemetry.A],
///     OtherManagers = [world.CreateVehicle(telemetry.B)],
///     Camera = world.CreateCamera(),
///     Imaging = new ImageProcessingOptions { Camera = world.CameraModel, Mount = world.CameraMount },
///     Time = new VirtualTime(seed: 7),
/// });
/// </code>
/// </example>
public sealed class SimulatedWorld
{
    /// <summary>The name of the vehicle's manager.</summary>
    public const string VehicleManagerName = "simulated vehicle";

    // At 100 steps a second: 4 s.
    private const int HistoryLength = 400;

    private readonly TruthRecorder _recorder = new();
    private bool _hasVehicle;

    // The same things on the ground, and another vehicle; home is where that stands.
    private SimulatedWorld(SimulationOptions options, SimulatedWorld shared, TimeSpan switchedOnAt)
    {
        Options = options.ValidatedCopy(nameof(options));
        Frame = new WorldFrame(Options.Home);
        Things = shared.Things
            .Select(t => t.At(
                NedPosition.Origin + Frame.ToWorld(shared.PositionOf(t.Position)) with { Down = 0 }, switchedOnAt))
            .ToArray();
        Occluders = shared.Occluders
            .Select(o => o with
            {
                Position = NedPosition.Origin + Frame.ToWorld(shared.PositionOf(o.Position)) with { Down = 0 },
            })
            .ToArray();
    }

    /// <summary>Makes the world; nothing moves yet.</summary>
    /// <param name="options">Checked and read now; later changes have no effect.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public SimulatedWorld(SimulationOptions options)
    {
        Options = (options ?? throw new ArgumentNullException(nameof(options))).ValidatedCopy(nameof(options));
        Frame = new WorldFrame(Options.Home);
        Things = TargetField.Place(
            unchecked((ulong)Options.Seed), Options.Area, Options.TargetCount, Options.DistractorCount,
            Options.TargetKinds, Options.PartlyHiddenCount)
            .Select(WithMotion).ToArray();
        Occluders = Options.Occluders.Concat(OccluderField.Place(
            unchecked((ulong)Options.Seed), Options.Area, Things, Options.OccluderCount)).ToArray();
    }

    /// <summary>The targets.</summary>
    public IEnumerable<SimulatedTarget> Targets => Things.Where(t => !t.IsDistractor);

    /// <summary>Trees and roofs, those that were asked for and those of the seed.</summary>
    public IReadOnlyList<SimulatedOccluder> Occluders { get; }

    /// <summary>The camera's pinhole and lens.</summary>
    public CameraModel CameraModel => Options.Camera.Camera;

    /// <summary>How the camera is mounted, as far as the operator knows: misalignments are to be estimated.</summary>
    public CameraMount CameraMount => new()
    {
        GimbalFrame = Options.Camera.GimbalFrame,
        GimbalLeverArmMetres = new BodyVector(
            Options.Camera.LeverArmForwardMetres, Options.Camera.LeverArmRightMetres,
            Options.Camera.LeverArmDownMetres),
    };

    /// <summary>What the vehicle has really done until now. A new snapshot at each call. Any thread.</summary>
    public SimulatedTruth Truth => _recorder.Snapshot();

    internal SimulationOptions Options { get; }

    /// <summary>Targets and distractors.</summary>
    internal IReadOnlyList<SimulatedTarget> Things { get; }

    internal WorldFrame Frame { get; }

    internal TruthHistory History { get; } = new(HistoryLength);

    /// <summary>
    /// Makes the manager that runs the vehicle. It may be in the reactor of the companion computer, or in a reactor
    /// or a process of its own. Once.
    /// </summary>
    /// <param name="link">
    /// Its telemetry; open, and closed by the caller after the run. Its end does not end the vehicle.
    /// </param>
    /// <param name="signingKey">
    /// Where the link is signed, the key: the vehicle then signs what it sends and rejects what is not signed with
    /// it. The caller disposes of it.
    /// </param>
    /// <exception cref="InvalidOperationException">There is a vehicle already.</exception>
    public RabitManager CreateVehicle(IByteLink link, MavlinkSigningKey? signingKey = null)
    {
        if (link is null)
            throw new ArgumentNullException(nameof(link));
        if (_hasVehicle)
            throw new InvalidOperationException("The simulated world has its vehicle already.");
        _hasVehicle = true;
        var delayed = new DelayedFrames(
            new SimulationRandom(Options.Seed, "telemetry latency"), Options.TelemetryLatency);
        return new SimulatedVehicleManager(
            VehicleManagerName, CreateVehicle(), delayed, _recorder, link,
            signingKey is null ? null : new VehicleSigning(signingKey),
            new TelemetryFaults(Options.Faults));
    }

    /// <summary>
    /// Makes the camera of the vehicle, as the source of a reader in the same reactor or in one with the same clock.
    /// </summary>
    public SimulatedCamera CreateCamera()
        => new(
            Options.Camera.With(Options.Faults), History,
            Things.Concat(Occluders.Select((o, i) => OccluderField.SheetOf(o, i, unchecked((ulong)Options.Seed)))),
            unchecked((ulong)Options.Seed), Options.Faults);

    /// <summary>The companion computer, for <see cref="UavOptions.Computer"/>.</summary>
    public SimulatedComputer CreateComputer() => new(Options.Faults);

    /// <summary>
    /// Adds to the time of a run which of the managers on board hang, when and for how long (
    /// <see cref="ScriptedFaultKind.ManagerHangs"/>). Before the start.
    /// </summary>
    /// <param name="time">
    /// That of the reactor in which those managers are: a manager that it does not have is an error at the start.
    /// </param>
    public void AddHangsTo(VirtualTime time)
    {
        if (time is null)
            throw new ArgumentNullException(nameof(time));
        foreach (ScriptedFault fault in Options.Faults.Where(f => f.Kind == ScriptedFaultKind.ManagerHangs))
            time.AddLongUnitOfWork(fault.Manager!, fault.At, fault.Duration);
    }

    /// <summary>Where something of the world is, by the earth's coordinates.</summary>
    /// <param name="position">In the frame of the world.</param>
    public GeodeticPosition PositionOf(NedPosition position) => Frame.ToPlace(position - NedPosition.Origin);

    /// <summary>The same world with another vehicle, whose clock begins later.</summary>
    internal SimulatedWorld With(SimulationOptions options, TimeSpan switchedOnAt) => new(options, this, switchedOnAt);

    /// <summary>The vehicle alone, to be stepped by a test.</summary>
    internal SimulatedVehicle CreateVehicle(int linkCount = 1) => new(Options, Frame, History, _recorder, linkCount);

    private SimulatedTarget WithMotion(SimulatedTarget target)
    {
        SimulatedMotion motion = target.IsDistractor || target.Id > Options.Motions.Count
            ? SimulatedMotion.Standing
            : Options.Motions[target.Id - 1];
        return motion == SimulatedMotion.Standing
            ? target
            : target.With(motion, TargetRoutes.Make(unchecked((ulong)Options.Seed), target, motion, Options.Area));
    }
}
