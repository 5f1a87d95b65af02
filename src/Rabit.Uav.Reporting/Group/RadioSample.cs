using System;

namespace Rabit.Uav.Reporting;

/// <summary>How much a vehicle had sent by radio at a time. A plain value.</summary>
/// <param name="Time">By the clock of the group.</param>
/// <param name="BytesSent">Since the start.</param>
public readonly record struct RadioSample(TimeSpan Time, long BytesSent);
