using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// The energy of the flight for the ground station: NAMED_VALUE_FLOAT, one at a time, in turn. A value that is not
/// known or not finite is left out. No I/O; one thread.
/// </summary>
internal sealed class EnergyTelemetry
{
    // Names have at most 10 characters (common.xml). No others of this system's begin with "En".
    private static readonly Text10[] Names =
    [
        new("EnLeft"), new("EnLeftSd"), new("EnToHome"), new("EnToHomeSd"), new("EnReturnIn"), new("EnTimeHome"),
        new("EnCapacity"),
    ];

    private int _next;

    /// <returns>What is to be sent now; null where nothing is known.</returns>
    public NamedValueFloat? Next(in EnergyStatus energy, TimeSpan now)
    {
        if (!energy.IsKnown)
            return null;
        for (int tries = 0; tries < Names.Length; tries++)
        {
            int index = _next;
            _next = (_next + 1) % Names.Length;
            float value = (float)Value(index, energy);
            if (float.IsNaN(value) || float.IsInfinity(value))
                continue;
            return new NamedValueFloat
            {
                TimeBootMs = unchecked((uint)(now.Ticks / TimeSpan.TicksPerMillisecond)),
                Name = Names[index],
                Value = value,
            };
        }

        return null;
    }

    // In the order of the names: per cent of the true capacity, seconds, and per cent of the stated capacity.
    private static double Value(int index, in EnergyStatus energy) => index switch
    {
        0 => 100 * energy.ChargeLeft,
        1 => 100 * energy.ChargeLeftDeviation,
        2 => 100 * energy.ChargeHome,
        3 => 100 * energy.ChargeHomeDeviation,
        4 => energy.TimeToReturn.ExactSeconds,
        5 => double.IsInfinity(energy.ChargeHome) ? double.PositiveInfinity : energy.TimeHome.ExactSeconds,
        _ => 100 * energy.CapacityFraction,
    };
}
