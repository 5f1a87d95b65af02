using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// What is truly left in the battery. The autopilot counts its percentage from the stated capacity, of which an aged
/// battery has less: left = start - used / capacity, used and capacity as fractions of the stated one. Start and
/// 1 / capacity are estimated by a Kalman filter from the voltage at rest, V + I R; see <see cref="CellVoltage"/>. It
/// never takes more for left than the autopilot. No I/O; one thread.
/// </summary>
internal sealed class ChargeEstimator(EnergyOptions options)
{
    // A percentage at the start is that of a battery at rest, or was entered by someone.
    private const double StartDeviation = 0.03;

    // Where the percentage at the start is this much above the voltage, an autopilot took its battery for full
    // (ArduPilot does at each start): the curve is less wrong than that.
    private const double MaxOfVoltage = 0.15;
    private const double VoltageStartDeviation = 0.08;
    private const double FailedCell = 0.3;

    // The mean of the voltage has followed by then.
    private static readonly TimeSpan FailedCellDwell = TimeSpan.FromSeconds(20);

    // Batteries in use have 75 % to 105 % of what stands on them.
    private const double PriorInverseCapacity = 1.12;
    private const double InverseCapacityDeviation = 0.15;
    private const double MinInverseCapacity = 0.95;
    private const double MaxInverseCapacity = 2;

    // The curve is wrong by the same over about a tenth of the charge: five of these say as much as one.
    private const double UsedPerMeasurement = 0.02;
    private const double Correlated = 5;

    // Per cent are whole, at the start and now.
    private const double HalfPercent = 0.005;
    private const double MinUsedForCapacity = 0.05;
    private const double JumpFraction = 0.05;

    // Reported once a second, by two messages: both may have one wrong count.
    private static readonly TimeSpan JumpDwell = TimeSpan.FromSeconds(1);

    private const double MaxStepSeconds = 5;

    private readonly RestVoltage _rest = new(options);
    private TimeSpan? _time;
    private TimeSpan? _failedSince;
    private double _drawn;
    private bool _isAnchored;
    private bool _countsItself;
    private double _anchorRemaining;
    private double _anchorDrawn;
    private double _lastRemaining = double.NaN;
    private double _jumpedTo = double.NaN;
    private TimeSpan _jumpTime;
    private bool _isUsedKnown;
    private double _used;
    private double _nextMeasurement;
    private double _start;
    private double _inverse = PriorInverseCapacity;
    private double _startVariance;
    private double _covariance;
    private double _inverseVariance = InverseCapacityDeviation * InverseCapacityDeviation;

    /// <summary>
    /// Whether it can be estimated: not while neither the percentage nor what was drawn is reported.
    /// </summary>
    public bool IsKnown => _isAnchored && _isUsedKnown;

    /// <summary>What is left, 0 to 1 of the true capacity.</summary>
    public double Left { get; private set; } = double.NaN;

    /// <summary>Its standard deviation.</summary>
    public double LeftDeviation => Math.Sqrt(Math.Max(
        0, _startVariance - (2 * _used * _covariance) + (_used * _used * _inverseVariance)));

    /// <summary>True capacity over the stated one.</summary>
    public double CapacityFraction => 1 / _inverse;

    /// <summary>Its standard deviation.</summary>
    public double CapacityFractionDeviation => Math.Sqrt(_inverseVariance) / (_inverse * _inverse);

    /// <summary>Ampere hours that stand on it, as far as they are known.</summary>
    public double StatedAmpereHours { get; private set; } = options.CapacityAmpereHours;

    /// <summary>Takes what is reported of the battery.</summary>
    /// <returns>Whether it is new.</returns>
    public bool Update(in VehicleState vehicle)
    {
        if (vehicle.BatteryTime is not { } time || time == _time)
            return false;
        double seconds = _time is { } last ? Math.Min((time - last).ExactSeconds, MaxStepSeconds) : 0;
        _time = time;
        if (vehicle.BatteryAmperes > 0)
            _drawn += vehicle.BatteryAmperes * seconds / 3600;
        _rest.Update(vehicle, time, seconds);
        if (!_isAnchored)
            Begin(vehicle);
        if (_isAnchored)
            Count(vehicle);
        return true;
    }

    /// <summary>What may be left at most: never more than the autopilot reports.</summary>
    /// <param name="doubt">How much more than the estimate.</param>
    public double MaxLeft(double doubt) => _lastRemaining < Left + doubt ? _lastRemaining : Left + doubt;

    /// <summary>The fraction of the true capacity that an energy is.</summary>
    /// <param name="joules">The energy.</param>
    /// <param name="watts">The power at which it is drawn.</param>
    public double FractionOf(double joules, double watts)
        => joules / (3600 * _rest.VoltsUnder(watts) * StatedAmpereHours / _inverse);

    /// <summary>The power that a loss of the autopilot's percentage means, watts.</summary>
    public double WattsOf(double remainingPerSecond)
        => remainingPerSecond * 3600 * _rest.VoltsUnder(options.HoverWatts) * StatedAmpereHours;

    private void Begin(in VehicleState vehicle)
    {
        double ofVoltage = _rest.Charge;
        double reported = vehicle.BatteryRemaining;
        if (double.IsNaN(reported) && (double.IsNaN(ofVoltage) || double.IsNaN(vehicle.BatteryAmperes)))
            return;
        bool isByVoltage = !(reported - ofVoltage <= MaxOfVoltage) && !double.IsNaN(ofVoltage);
        double deviation = isByVoltage ? VoltageStartDeviation : StartDeviation;
        Anchor(vehicle, isByVoltage ? ofVoltage : reported, deviation);
    }

    private void Anchor(in VehicleState vehicle, double left, double deviation)
    {
        _countsItself = double.IsNaN(vehicle.BatteryConsumedAmpereHours);
        (_anchorRemaining, _anchorDrawn) = (vehicle.BatteryRemaining, Drawn(vehicle));
        (_start, _startVariance, _covariance) = (left, deviation * deviation, 0);
        (_used, _nextMeasurement, _lastRemaining) = (0, UsedPerMeasurement, vehicle.BatteryRemaining);
        (_isAnchored, _jumpedTo) = (true, double.NaN);
    }

    private double Drawn(in VehicleState vehicle) => _countsItself ? _drawn : vehicle.BatteryConsumedAmpereHours;

    private void Count(in VehicleState vehicle)
    {
        if (!TakeRemaining(vehicle))
            return;
        double used = Used(vehicle);
        _isUsedKnown = !double.IsNaN(used);
        if (used > _used)
            _used = used;
        if (_used >= _nextMeasurement)
        {
            _nextMeasurement = _used + UsedPerMeasurement;
            Measure();
        }

        SetLeft(vehicle);
    }

    // A percentage that jumps counts when it has stayed there for a second.
    private bool TakeRemaining(in VehicleState vehicle)
    {
        double remaining = vehicle.BatteryRemaining;
        if (double.IsNaN(Left))
            Left = _start;
        bool isJump = Math.Abs(remaining - _lastRemaining) > JumpFraction;
        TimeSpan time = vehicle.BatteryTime!.Value;
        if (isJump && !(Math.Abs(remaining - _jumpedTo) <= JumpFraction))
            (_jumpedTo, _jumpTime) = (remaining, time);
        if (isJump && time - _jumpTime < JumpDwell)
            return false;

        // Another battery, or the autopilot has started again and takes it for full.
        if (isJump)
            Anchor(vehicle, Math.Min(remaining, Left), VoltageStartDeviation);
        else if (double.IsNaN(vehicle.BatteryConsumedAmpereHours) != _countsItself)
            Anchor(vehicle, Left, LeftDeviation);
        if (!double.IsNaN(remaining))
            _lastRemaining = remaining;
        _jumpedTo = double.NaN;
        return true;
    }

    private void SetLeft(in VehicleState vehicle)
    {
        // A cell has failed: no curve is as wrong as that.
        double ofVoltage = _rest.Charge;
        double left = _start - (_used * _inverse);
        bool isFar = ofVoltage < left - FailedCell;
        _failedSince = isFar ? _failedSince ?? _time : null;
        if (_time - _failedSince >= FailedCellDwell)
        {
            Anchor(vehicle, ofVoltage, VoltageStartDeviation);
            left = ofVoltage;
        }

        if (_lastRemaining < left)
            left = _lastRemaining;
        Left = Math.Max(0, left);
    }

    // By the charge drawn, which is finer than whole per cent, and by these.
    private double Used(in VehicleState vehicle)
    {
        double byPercent = _anchorRemaining - vehicle.BatteryRemaining;
        double drawn = Drawn(vehicle) - _anchorDrawn;
        bool hasCurrent = !_countsItself || !double.IsNaN(vehicle.BatteryAmperes);
        if (hasCurrent && byPercent >= MinUsedForCapacity && drawn > 0)
        {
            double least = drawn / (byPercent + HalfPercent + HalfPercent);
            double most = drawn / (byPercent - HalfPercent - HalfPercent);
            StatedAmpereHours = Math.Min(Math.Max(StatedAmpereHours, least), most);
        }

        double byCharge = drawn / StatedAmpereHours;
        if (!hasCurrent || double.IsNaN(byCharge))
            return byPercent;
        return double.IsNaN(byPercent)
            ? byCharge
            : Math.Min(
                Math.Max(byCharge, byPercent - HalfPercent - HalfPercent), byPercent + HalfPercent + HalfPercent);
    }

    private void Measure()
    {
        double measured = _rest.Charge;
        if (!(measured <= CellVoltage.MaxCharge))
            return;
        double deviation = CellVoltage.DeviationOf(measured, _rest.LoadDeviationVolts);
        double ofStart = _startVariance - (_used * _covariance);
        double ofInverse = _covariance - (_used * _inverseVariance);
        double variance = ofStart - (_used * ofInverse) + (Correlated * deviation * deviation);
        double error = measured - (_start - (_used * _inverse));
        _start += ofStart / variance * error;
        _inverse = Math.Min(
            Math.Max(_inverse + (ofInverse / variance * error), MinInverseCapacity), MaxInverseCapacity);
        _startVariance -= ofStart * ofStart / variance;
        _covariance -= ofStart * ofInverse / variance;
        _inverseVariance -= ofInverse * ofInverse / variance;
    }
}
