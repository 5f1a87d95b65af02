using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Open-circuit voltage of a lithium polymer cell against its charge: M. Chen, G. A. Rincon-Mora, "Accurate Electrical
/// Battery Model Capable of Predicting Runtime and I-V Performance", IEEE Transactions on Energy Conversion 21 (2),
/// 2006, equation 2. Measured on cells charged to 4.1 V: today's are charged to 4.2 V, and differ in the upper third.
/// </summary>
internal static class CellVoltage
{
    /// <summary>Above it the curve is not that of a cell charged to 4.2 V.</summary>
    public const double MaxCharge = 0.65;

    // Of published curves about each other, between a tenth and two thirds of the charge.
    private const double DeviationVolts = 0.015;

    // No part of the curve gives the charge better.
    private const double MinDeviation = 0.03;

    private const int Halvings = 20;

    /// <summary>Volts of a cell at rest.</summary>
    /// <param name="charge">0 to 1.</param>
    public static double VoltsOf(double charge)
        => 3.685 - (1.031 * Math.Exp(-35 * charge))
            + (charge * (0.2156 + (charge * (-0.1178 + (charge * 0.3201)))));

    /// <summary>The charge, 0 to 1, of a cell with a voltage at rest.</summary>
    public static double ChargeOf(double volts)
    {
        (double low, double high) = (0, 1);
        for (int i = 0; i < Halvings; i++)
        {
            double middle = (low + high) / 2;
            if (VoltsOf(middle) < volts)
                low = middle;
            else
                high = middle;
        }

        return (low + high) / 2;
    }

    /// <summary>Standard deviation of a charge that a voltage gives, by the slope of the curve there.</summary>
    /// <param name="charge">0 to 1.</param>
    /// <param name="moreVolts">Standard deviation of the voltage at rest, beside that of the curve.</param>
    public static double DeviationOf(double charge, double moreVolts)
    {
        double slope = (35 * 1.031 * Math.Exp(-35 * charge)) + 0.2156
            + (charge * (-0.2356 + (charge * 0.9603)));
        return Math.Max(MinDeviation, Math.Sqrt((DeviationVolts * DeviationVolts) + (moreVolts * moreVolts)) / slope);
    }
}
