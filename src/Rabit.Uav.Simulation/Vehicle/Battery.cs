using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// A lithium polymer pack: charge is counted, the voltage follows from what is left and from the current, U = cells *
/// Uoc(charge) - I * R. The autopilot counts its percentage from the stated capacity, of which an aged pack has less.
/// </summary>
/// <param name="statedAmpereHours">What stands on it, and in the autopilot's parameters.</param>
/// <param name="remaining">At the start, 0 to 1; the autopilot knows it.</param>
/// <param name="capacityFraction">True capacity over the stated one.</param>
internal sealed class Battery(double statedAmpereHours, double remaining, double capacityFraction = 1)
{
    private const int Cells = 3;
    private const double Resistance = 0.02;   // ohm, the whole pack and its leads
    private const double SecondsPerHour = 3600;

    // Open-circuit voltage of a cell from empty to full in steps of a tenth: a typical lithium polymer discharge
    // curve, full 4.2 V.
    private static readonly double[] CellVolts = [3.27, 3.61, 3.69, 3.73, 3.77, 3.80, 3.85, 3.92, 4.00, 4.09, 4.20];

    /// <summary>What is truly left of the true capacity, 0 to 1.</summary>
    public double Remaining { get; private set; } = remaining;

    /// <summary>What the autopilot reports: at the start the truth, then counted from the stated capacity.</summary>
    public double Reported { get; private set; } = remaining;

    public double Volts { get; private set; } = Cells * OpenCircuit(remaining);

    /// <summary>What its sensor says instead of <see cref="Volts"/>, as a script wants it; null: the same.</summary>
    public double? SensorVolts { get; set; }

    /// <summary>The voltage that the autopilot measures.</summary>
    public double MeasuredVolts => SensorVolts ?? Volts;

    public double Amperes { get; private set; }

    /// <summary>Charge drawn since the start.</summary>
    public double ConsumedAmpereHours { get; private set; }

    public double ConsumedJoules { get; private set; }

    public bool IsEmpty => Remaining <= 0;

    /// <summary>Gives it another state, as a script wants it.</summary>
    public void Set(double newRemaining) => Remaining = Reported = newRemaining;

    /// <summary>Gives it another state of which the autopilot does not know.</summary>
    public void SetTrue(double newRemaining) => Remaining = newRemaining;

    /// <summary>Draws a power for a time.</summary>
    public void Step(double watts, double seconds)
    {
        // U = Uoc - I R and U I = P: the smaller root; where the pack cannot give the power, the most that it can.
        double open = Cells * OpenCircuit(Remaining);
        double root = (open * open) - (4 * Resistance * watts);
        Amperes = (open - Math.Sqrt(Math.Max(0, root))) / (2 * Resistance);
        Volts = open - (Amperes * Resistance);
        double hours = Amperes * seconds / SecondsPerHour;
        ConsumedAmpereHours += hours;
        ConsumedJoules += Volts * Amperes * seconds;
        Remaining = Math.Max(0, Remaining - (hours / (capacityFraction * statedAmpereHours)));
        Reported = Math.Max(0, Reported - (hours / statedAmpereHours));
    }

    private static double OpenCircuit(double charge)
    {
        double place = NedMath.Limited(charge, 0, 1) * (CellVolts.Length - 1);
        int below = Math.Min((int)place, CellVolts.Length - 2);
        return CellVolts[below] + ((place - below) * (CellVolts[below + 1] - CellVolts[below]));
    }
}
