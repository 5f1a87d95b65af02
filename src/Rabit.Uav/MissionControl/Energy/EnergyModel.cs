using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The energy of the flight: the charge that is left, the power that the vehicle needs, and with the wind what the way
/// home takes. Learnt in flight from what the autopilot reports. No I/O; one thread.
/// </summary>
internal sealed class EnergyModel
{
    // Both sides of the comparison may be wrong: a return too early costs a part of the search, one too late the
    // vehicle.
    private const double Deviations = 1.25;

    // To land in a field there must be no doubt that home cannot be reached: the curve of the voltage takes so much too
    // little for left in a battery that is nearly empty.
    private const double DeviationsOutOfReach = 2;
    private const double MinDoubt = 0.08;
    private const double ReserveOfLanding = 0.03;

    private const double BrakingMetresPerSecondSquared = 2;
    private const double Px4BackSpeed = 0.4;
    private const double MaxStartSeconds = 120;

    // Where the current is not reported: so many whole per cent say enough of the power.
    private const double MinFractionForPower = 0.02;

    // More at once was not used: the percentage jumped.
    private const double MaxFractionForPower = 0.05;

    // Reported once a second.
    private static readonly TimeSpan MaxBatteryAge = TimeSpan.FromSeconds(10);

    private readonly EnergyOptions _options;
    private readonly ChargeEstimator _charge;
    private readonly PowerModel _power;
    private readonly WindEstimate _wind = new();
    private TimeSpan? _sampleTime;
    private double _sampleRemaining;
    private double _seconds;
    private double _cubedSeconds;
    private double _climbed;
    private EnergyStatus _status;

    public EnergyModel(EnergyOptions options, MissionPlan mission)
    {
        (_options, Mission) = (options, mission);
        _charge = new ChargeEstimator(options);
        _power = new PowerModel(options);
    }

    public ref readonly EnergyStatus Status => ref _status;

    /// <summary>The mission as it is now.</summary>
    public MissionPlan Mission { get; set; }

    /// <summary>Parameters of the autopilot, for the speed of its return.</summary>
    public AutopilotParameters Parameters { get; set; } = AutopilotParameters.None;

    /// <summary>Takes what is new, at each unit of work.</summary>
    public void Update(MissionFlight flight)
    {
        bool isFlying = flight.IsFlying;
        _wind.Update(flight.Vehicle, flight.Now, isFlying);
        if (_charge.Update(flight.Vehicle))
            Learn(flight.Vehicle, isFlying);
        Judge(flight, isFlying);
    }

    /// <summary>Whether the battery can fly the plan, by what is known before the take-off.</summary>
    /// <returns>Why not, with the figures; null where it can, or where the battery is not known.</returns>
    public string? CheckPlan(MissionFlight flight)
    {
        // A fixed wing has no power of hovering to begin with.
        if (flight.IsFixedWing)
            return null;
        (double joules, double seconds) = PlanEnergy.Of(
            _power, flight.Route!, flight.Plan!, Mission, _options.AssumedWindMetresPerSecond, SpeedHome(flight),
            _options.MaxAirspeedMetresPerSecond, StartSeconds(flight));
        bool isEndless = double.IsInfinity(joules);
        _status.PlanCharge = _charge.FractionOf(joules, joules / seconds);
        _status.PlanTime = isEndless ? TimeSpan.MaxValue : TimeSpan.OfSeconds(seconds);
        if (!_charge.IsKnown || _status.PlanCharge + Mission.EnergyReserveFraction <= _charge.Left)
            return null;
        string wind = $"in a wind of {MissionNumbers.Of(_options.AssumedWindMetresPerSecond)} m/s";
        return isEndless
            ? $"the plan cannot be flown {wind}: the way home would be against it"
            : $"the plan takes {MissionNumbers.Of(seconds / 60)} min and {MissionNumbers.Percent(_status.PlanCharge)} of "
                + $"the battery {wind}, with a reserve of {MissionNumbers.Percent(Mission.EnergyReserveFraction)}; "
                + $"{MissionNumbers.Percent(_charge.Left)} are left";
    }

    private void Learn(in VehicleState vehicle, bool isFlying)
    {
        TimeSpan time = vehicle.BatteryTime!.Value;
        double seconds = _sampleTime is { } last && isFlying ? (time - last).ExactSeconds : 0;
        _sampleTime = time;
        if (!(seconds > 0))
        {
            BeginSample(vehicle);
            return;
        }

        var ground = new PlanePoint(vehicle.VelocityNed.North, vehicle.VelocityNed.East);
        double airspeed = (ground - _wind.Latest).Length;
        _seconds += seconds;
        _cubedSeconds += seconds * airspeed * airspeed * airspeed;
        _climbed -= seconds * vehicle.VelocityNed.Down;
        double watts = vehicle.BatteryVolts * vehicle.BatteryAmperes;
        if (double.IsNaN(watts))
        {
            double used = _sampleRemaining - vehicle.BatteryRemaining;
            if (double.IsNaN(_sampleRemaining) || Math.Abs(used) > MaxFractionForPower)
                BeginSample(vehicle);
            if (!(used >= MinFractionForPower && used <= MaxFractionForPower))
                return;
            watts = _charge.WattsOf(used / _seconds);
        }

        if (watts > 0)
            _power.Update(watts, _cubedSeconds / _seconds, _climbed / _seconds, _seconds);
        BeginSample(vehicle);
    }

    private void BeginSample(in VehicleState vehicle)
    {
        (_seconds, _cubedSeconds, _climbed) = (0, 0, 0);
        _sampleRemaining = vehicle.BatteryRemaining;
    }

    private void Judge(MissionFlight flight, bool isFlying)
    {
        _status.IsKnown = _charge.IsKnown && flight.Plan is not null && flight.Vehicle.PositionTime is not null
            && flight.Now - flight.Vehicle.BatteryTime <= MaxBatteryAge && !flight.IsFixedWing;
        _status.Reserve = Mission.EnergyReserveFraction;
        (_status.ChargeLeft, _status.ChargeLeftDeviation) = (_charge.Left, _charge.LeftDeviation);
        (_status.CapacityFraction, _status.CapacityFractionDeviation)
            = (_charge.CapacityFraction, _charge.CapacityFractionDeviation);
        _status.HoverWatts = _power.HoverWatts;
        _status.CruiseWatts = _power.Watts(Mission.SpeedMetresPerSecond);
        _status.ClimbWattsPerMetrePerSecond = _power.ClimbWattsPerMetrePerSecond;
        _status.IsWindMeasured = _wind.IsMeasured;
        if (_status.IsKnown)
            JudgeWayHome(flight, isFlying);
        else
            (_status.MustReturn, _status.IsHomeOutOfReach) = (false, false);
    }

    private void JudgeWayHome(MissionFlight flight, bool isFlying)
    {
        double assumed = _wind.IsMeasured ? 0 : _options.AssumedWindMetresPerSecond;
        (double joules, double seconds) = Home(flight, assumed);
        (double high, _) = Home(flight, assumed + _options.WindDeviationMetresPerSecond);
        double watts = double.IsInfinity(joules) ? _power.HoverWatts : joules / seconds;
        double home = _charge.FractionOf(joules, watts);
        double ofWind = _charge.FractionOf(high, watts) - home;
        double ofPower = home * _power.Deviation(airspeed: 0) / _power.HoverWatts;
        double ofCapacity = home * _charge.CapacityFractionDeviation / _charge.CapacityFraction;
        double ofHome = double.IsInfinity(home)
            ? 0
            : Math.Sqrt((ofWind * ofWind) + (ofPower * ofPower) + (ofCapacity * ofCapacity));
        double ofLeft = _charge.LeftDeviation;
        double margin = _charge.Left - home - Mission.EnergyReserveFraction
            - (Deviations * Math.Sqrt((ofHome * ofHome) + (ofLeft * ofLeft)));
        (double landing, double landingSeconds) = WayHome.Landing(_power, flight.HeightMetres, _wind.Velocity.Length);
        double toLand = _charge.FractionOf(landing, landing / landingSeconds);
        _status.IsKnown = !double.IsNaN(margin);
        _status.ChargeHome = home;
        _status.ChargeHomeDeviation = ofHome;
        _status.TimeHome = double.IsInfinity(seconds) ? TimeSpan.MaxValue : TimeSpan.OfSeconds(seconds);
        double perSecond = _charge.FractionOf(_power.HoverWatts, _power.HoverWatts);
        _status.TimeToReturn = margin > 0 ? TimeSpan.OfSeconds(margin / perSecond) : TimeSpan.Zero;
        _status.MustReturn = isFlying && margin <= 0;
        _status.IsHomeOutOfReach = isFlying
            && _charge.MaxLeft(Math.Max(DeviationsOutOfReach * ofLeft, MinDoubt)) < home
            && _charge.Left <= toLand + ReserveOfLanding;
    }

    private double SpeedHome(MissionFlight flight)
        => _options.ReturnSpeedMetresPerSecond ?? ReturnSpeed.Of(Parameters, flight.Vehicle.Autopilot);

    private (double Joules, double Seconds) Home(MissionFlight flight, double moreHeadWind) => WayHome.Of(
        _power, flight.Position, flight.HeightMetres, _wind.Velocity, moreHeadWind,
        SpeedHome(flight), _options.MaxAirspeedMetresPerSecond, StartSeconds(flight));

    // A return begins with braking. PX4 goes back to where it began, at 0.4 m/s (recorded: 0.3 to 0.8), which is as far
    // as it took to brake, at 2 m/s2.
    private double StartSeconds(MissionFlight flight)
    {
        if (flight.Commands.GoalKind == VehicleCommandKind.Return)
            return 0;
        double speed = Mission.SpeedMetresPerSecond;
        double braking = speed / BrakingMetresPerSecondSquared;
        return flight.Vehicle.Autopilot == MavAutopilot.Px4
            ? Math.Min(braking + (speed * braking / 2 / Px4BackSpeed), MaxStartSeconds)
            : braking;
    }
}
