using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The battery's resistance, with its leads: by how much the voltage falls when the current rises, from one report to
/// the next. A weighted mean, the prior included. No time, no I/O; one thread.
/// </summary>
internal sealed class InternalResistance
{
    // A pack of some ampere hours has 2 to 10 mOhm a cell, with its leads.
    private const double PriorOhmsPerCell = 0.007;

    // As much as one change of 5 A.
    private const double PriorWeight = 25;

    // Smaller changes are those of the charge and of rounding.
    private const double MinChangeAmperes = 2;

    // It grows as the battery cools and empties: older changes count less, half after some 70 newer ones.
    private const double Kept = 0.99;

    // What changes the voltage by more is no resistance: a cell has failed.
    private const double MaxOhmsPerCell = 0.03;

    private static readonly TimeSpan MaxGap = TimeSpan.FromSeconds(3);

    private double _weight = PriorWeight;
    private double _sum;
    private TimeSpan _time;
    private double _volts = double.NaN;
    private double _amperes = double.NaN;

    /// <summary>Ohms of the whole pack.</summary>
    /// <param name="cells">In series.</param>
    public double Ohms(int cells)
    {
        double prior = PriorOhmsPerCell * cells;
        double ohms = ((prior * PriorWeight) + _sum) / _weight;
        return Math.Min(Math.Max(ohms, prior / 5), prior * 5);
    }

    /// <summary>Takes what was measured at the same time.</summary>
    public void Update(double volts, double amperes, int cells, TimeSpan time)
    {
        double change = amperes - _amperes;
        double fall = _volts - volts;
        bool isPossible = fall * change >= 0 && Math.Abs(fall) <= Math.Abs(change) * MaxOhmsPerCell * cells;
        if (isPossible && Math.Abs(change) >= MinChangeAmperes && time - _time <= MaxGap)
        {
            _sum = (_sum * Kept) + (change * fall);
            _weight = PriorWeight + ((_weight - PriorWeight) * Kept) + (change * change);
        }

        (_time, _volts, _amperes) = (time, volts, amperes);
    }
}
