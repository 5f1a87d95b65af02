using System;
using System.Collections.Generic;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// What is assumed of the vehicle's battery and power before a flight has measured it, and of the wind. The defaults
/// are those of a quadrotor of about 2 kg. Read once, when the manager is constructed.
/// </summary>
/// <example>
/// <code>
/// var options = new MissionControlOptions
/// {
///     Energy = new EnergyOptions { CapacityAmpereHours = 16, HoverWatts = 420, MaxAirspeedMetresPerSecond = 18 },
/// };
/// </code>
/// </example>
public sealed class EnergyOptions
{
    /// <summary>
    /// Stated capacity of the battery, ampere hours: from which the autopilot counts its percentage. Measured once
    /// 5 % are used, where the autopilot reports the charge drawn or the current.
    /// </summary>
    /// <value>Above 0. The default is 8.</value>
    public double CapacityAmpereHours { get; set; } = 8;

    /// <summary>Cells in series; null: from the voltage at the start, up to 8 of them.</summary>
    /// <value>1 to 24. The default is null.</value>
    public int? Cells { get; set; }

    /// <summary>Power in hover without wind, watts.</summary>
    /// <value>Above 0. The default is 190.</value>
    public double HoverWatts { get; set; } = 190;

    /// <summary>What is added to it in cruise: drag, watts per cubed metre per second of airspeed.</summary>
    /// <value>Zero or more. The default is 0.05: half again as much as in hover at 12 m/s.</value>
    public double DragWattsPerCubedSpeed { get; set; } = 0.05;

    /// <summary>What is added to it in a climb, watts per metre per second.</summary>
    /// <value>Zero or more. The default is 20: the weight of 2 kg.</value>
    public double ClimbWattsPerMetrePerSecond { get; set; } = 20;

    /// <summary>Airspeed that the vehicle can hold: with the wind it limits the ground speed home.</summary>
    /// <value>Metres per second, above 0. The default is 15.</value>
    public double MaxAirspeedMetresPerSecond { get; set; } = 15;

    /// <summary>
    /// Ground speed of the autopilot's return; null: by its parameters (RTL_SPEED or WPNAV_SPEED, MPC_XY_CRUISE), 5 m/s
    /// where they are not read.
    /// </summary>
    /// <value>Metres per second, above 0. The default is null.</value>
    public double? ReturnSpeedMetresPerSecond { get; set; }

    /// <summary>
    /// Wind that is assumed before the flight, and in flight while the autopilot reports none: head wind on the way
    /// home.
    /// </summary>
    /// <value>Metres per second, zero or more. The default is 5: a fresh day.</value>
    public double AssumedWindMetresPerSecond { get; set; } = 5;

    /// <summary>
    /// What the wind on the way home may be above the measured one: its standard deviation as it rises, and with gusts.
    /// </summary>
    /// <value>Metres per second, zero or more. The default is 2.</value>
    public double WindDeviationMetresPerSecond { get; set; } = 2;

    internal EnergyOptions Copy() => (EnergyOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        foreach ((string name, double value, bool mayBeZero) in Values())
        {
            if (!(value > 0 || (mayBeZero && value.Equals(0d))) || double.IsInfinity(value))
            {
                yield return FormattableString.Invariant(
                    $"{name} is {value}; it must be {(mayBeZero ? "0 or more" : "above 0")}");
            }
        }

        if (Cells is < 1 or > 24)
            yield return FormattableString.Invariant($"{nameof(Cells)} is {Cells}; it must be 1 to 24");
    }

    private IEnumerable<(string Name, double Value, bool MayBeZero)> Values()
    {
        yield return (nameof(CapacityAmpereHours), CapacityAmpereHours, false);
        yield return (nameof(HoverWatts), HoverWatts, false);
        yield return (nameof(DragWattsPerCubedSpeed), DragWattsPerCubedSpeed, true);
        yield return (nameof(ClimbWattsPerMetrePerSecond), ClimbWattsPerMetrePerSecond, true);
        yield return (nameof(MaxAirspeedMetresPerSecond), MaxAirspeedMetresPerSecond, false);
        yield return (nameof(ReturnSpeedMetresPerSecond), ReturnSpeedMetresPerSecond ?? 1, false);
        yield return (nameof(AssumedWindMetresPerSecond), AssumedWindMetresPerSecond, true);
        yield return (nameof(WindDeviationMetresPerSecond), WindDeviationMetresPerSecond, true);
    }
}
