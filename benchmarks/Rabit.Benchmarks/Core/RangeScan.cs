using System;
using Rabit.Core;

namespace Rabit.Benchmarks.Core;

/// <summary>A message with an array that is filled in again and again: 72 bytes of points.</summary>
internal sealed class RangeScan : ISelfCopying<RangeScan>
{
    public double[] Metres { get; } = new double[9];

    public RangeScan Clone()
    {
        var clone = new RangeScan();
        CopyTo(clone);
        return clone;
    }

    public void CopyTo(RangeScan target) => Metres.AsSpan().CopyTo(target.Metres);
}
