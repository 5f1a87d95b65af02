using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Several vehicles in one simulated world, each with its own reactor, and a radio between them. The reactors run in
/// lock step: each in turn for 20 ms, then the radio carries what was sent. Since nothing arrives sooner than that, the
/// result does not depend on who ran first, and a seed gives the same bytes each time. One thread.
/// </summary>
/// <example>
/// <code>
/// var group = new SimulatedGroup(new SimulatedGroupOptions { Vehicles = 3 });
/// for (int i = 0; i &lt; 3; i++)
/// {
///     SimulatedGroupVehicle vehicle = group.Vehicles[i];
///     var telemetry = new MemoryLinkPair("telemetry " + i);
///     UavSystem uav = UavSystem.Open(new UavOptions
///     {
///         OpenLinks = [telemetry.A, vehicle.Radio],
///         OtherManagers = [vehicle.World.CreateVehicle(telemetry.B)],
///         Time = vehicle.Time,
///         Communications =
///         {
///             LinkSettings = new Dictionary&lt;int, LinkSettings&gt;
///             {
///                 [0] = SimulatedGroupVehicle.TelemetrySettings,
///                 [1] = vehicle.RadioSettings,
///             },
///         },
///     });
///     group.Attach(i, uav.CreateReactor(new ReactorOptions { StopsOnSignals = false }));
/// }
///
/// while (group.Now &lt; TimeSpan.FromMinutes(1) &amp;&amp; group.Step())
/// {
/// }
///
/// group.Finish();
/// </code>
/// </example>
public sealed class SimulatedGroup
{
    // Landing places must be 10 m apart, and satellites say for each that it is somewhere within some metres.
    private const double StartSpacingMetres = 20;

    // A mission is flown from within 50 m of where its file says.
    private const int StartsInARow = 5;

    private readonly SimulatedGroupFault[] _faults;
    private readonly SimulatedRadio _radio;
    private readonly SeparationWatch _separation = new();

    /// <summary>Makes the world, the vehicles and the radio; nothing moves yet.</summary>
    /// <param name="options">Checked and read now.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public SimulatedGroup(SimulatedGroupOptions options)
    {
        (options ?? throw new ArgumentNullException(nameof(options))).Validate(nameof(options));
        _faults = options.Faults.OrderBy(f => f.At).ToArray();
        _radio = new SimulatedRadio(options.Radio.Copy(), options.World.Seed);
        var world = new SimulatedWorld(options.World);
        var vehicles = new List<SimulatedGroupVehicle>();
        for (int i = 0; i < options.Vehicles; i++)
        {
            int number = i;
            TimeSpan on = _faults.Where(f => f.Vehicle == number && f.Kind == SimulatedGroupFaultKind.SwitchedOn)
                .Select(f => f.At).FirstOrDefault();
            SimulatedWorld own = world.With(OptionsOf(options, i, world), on);
            vehicles.Add(new SimulatedGroupVehicle(
                own, new VirtualTime(own.Options.Seed, new DateTimeOffset(2000, 1, 1, 0, 0, 0, TimeSpan.Zero) + on),
                _radio.Add(() => Vehicles![number].Place), on)
            {
                Start = StartOf(i),
            });

            // What is sent to it before is not kept for it.
            if (on > TimeSpan.Zero)
                _radio.SwitchOff(i);
        }

        Vehicles = vehicles;
        GroundStations = options.GroundStations.Select((place, i) =>
        {
            var at = new NedPosition(place.NorthMetres, place.EastMetres, 0);
            return new SimulatedGroundStation((byte)(SimulatedGroundStation.FirstSystemId - i), _radio.Add(() => at));
        }).ToArray();
    }

    /// <summary>The vehicles.</summary>
    public IReadOnlyList<SimulatedGroupVehicle> Vehicles { get; }

    /// <summary>The ground stations; none unless there are some in the options.</summary>
    public IReadOnlyList<SimulatedGroundStation> GroundStations { get; }

    /// <summary>The clock of the group.</summary>
    public TimeSpan Now { get; private set; }

    /// <summary>Whether a vehicle still runs, or is to be switched on.</summary>
    public bool IsRunning => Vehicles.Any(v => !v.IsLost && v.Result is null);

    /// <summary>
    /// For each pair of vehicles that came nearer than 30 m over ground and 15 m in height, away from their landing
    /// places: how near.
    /// </summary>
    public IReadOnlyList<Separation> TooNear => _separation.TooNear;

    /// <summary>Pairs of vehicles that met in the air; they fly on.</summary>
    public IReadOnlyList<Separation> Collisions => _separation.Collisions;

    /// <summary>What a vehicle sent by radio, and what became of it.</summary>
    /// <param name="vehicle">The vehicle, from 0.</param>
    public RadioCounters RadioOf(int vehicle) => _radio.CountersOf(vehicle);

    /// <summary>States the reactor of a vehicle. Before the first step; it is started here.</summary>
    /// <param name="vehicle">The vehicle, from 0.</param>
    /// <param name="reactor">In the <see cref="SimulatedGroupVehicle.Time"/> of the vehicle.</param>
    public void Attach(int vehicle, RabitReactor reactor)
        => Vehicles[vehicle].Reactor = reactor ?? throw new ArgumentNullException(nameof(reactor));

    /// <summary>Runs all for one step of 20 ms. A reactor that was stopped is finished.</summary>
    /// <returns>Whether one still runs.</returns>
    /// <exception cref="InvalidOperationException">A vehicle has no reactor.</exception>
    public bool Step()
    {
        foreach (SimulatedGroupFault fault in _faults.Where(f => f.At >= Now && f.At < Now + Length))
            Begin(fault);
        Now += Length;
        for (int i = 0; i < Vehicles.Count; i++)
            Run(Vehicles[i], i);
        foreach (SimulatedGroundStation station in GroundStations)
            station.Step(Now);
        _radio.Exchange(Now);
        _separation.Update(Vehicles, Now);
        return IsRunning;
    }

    /// <summary>Stops and finishes all that still run.</summary>
    /// <param name="reason">Why, for the results of the reactors.</param>
    public void Finish(string reason = "the group ends")
    {
        foreach (SimulatedGroupVehicle vehicle in Vehicles.Where(v => v.HasStarted && v.Result is null))
        {
            vehicle.Reactor!.Stop(reason);
            vehicle.Result = vehicle.Reactor.Finish();
        }
    }

    private static TimeSpan Length => SimulatedRadioOptions.MinLatency;

    private void Begin(SimulatedGroupFault fault)
    {
        if (fault.Kind == SimulatedGroupFaultKind.Lost)
            Vehicles[fault.Vehicle].IsLost = true;
        if (fault.Kind is SimulatedGroupFaultKind.Lost or SimulatedGroupFaultKind.RadioDead)
            _radio.SwitchOff(fault.Vehicle);
    }

    private void Run(SimulatedGroupVehicle vehicle, int number)
    {
        if (vehicle.IsLost || vehicle.Result is not null || Now <= vehicle.SwitchedOnAt)
            return;
        RabitReactor reactor = vehicle.Reactor
            ?? throw new InvalidOperationException($"Vehicle {number} of the group has no reactor.");
        if (!vehicle.HasStarted)
        {
            reactor.Start();
            vehicle.HasStarted = true;
            if (!_faults.Any(f => f.Vehicle == number && f.Kind == SimulatedGroupFaultKind.RadioDead && f.At < Now))
                _radio.SwitchOn(number);
        }

        if (!reactor.RunFor(Length))
            vehicle.Result = reactor.Finish();
    }

    // To the east and to the west in turn, in rows of which each is to the south of the one before it.
    private static NedPosition StartOf(int vehicle)
    {
        int place = vehicle % StartsInARow;
        return new NedPosition(
            -StartSpacingMetres * (vehicle / StartsInARow),
            StartSpacingMetres * ((place + 1) / 2) * (place % 2 == 1 ? 1 : -1), 0);
    }

    private static SimulationOptions OptionsOf(SimulatedGroupOptions options, int vehicle, SimulatedWorld world)
    {
        SimulationOptions own = options.World.Copy();
        own.SystemId = (byte)(vehicle + 1);
        if (options.Faults.Any(f => f.Vehicle == vehicle && f.Kind == SimulatedGroupFaultKind.SameSystemId))
            own.SystemId = (byte)(vehicle == 0 ? 2 : vehicle);
        own.Seed = vehicle == 0 ? options.World.Seed : SeedOf(options.World.Seed, vehicle);
        own.Home = world.PositionOf(StartOf(vehicle));
        if (options.VehicleFaults.TryGetValue(vehicle, out IReadOnlyList<ScriptedFault>? more))
            own.Faults = [.. options.World.Faults, .. more];
        return own;
    }

    private static long SeedOf(long seed, int vehicle)
        => unchecked((long)new SimulationRandom(seed, FormattableString.Invariant($"vehicle {vehicle}")).Next());
}
