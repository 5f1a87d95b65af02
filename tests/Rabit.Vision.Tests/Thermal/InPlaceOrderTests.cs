using System;
using System.Linq;
using Xunit;

namespace Rabit.Vision.Tests.Thermal;

public sealed class InPlaceOrderTests
{
    [Fact]
    public void NthAndSortDescending_RandomValues_AreThoseOfTheRuntime()
    {
        const int seed = 4;
        var random = new Random(seed);
        for (int count = 1; count < 200; count++)
        {
            ushort[] values = [.. Enumerable.Range(0, count).Select(_ => (ushort)random.Next(count))];
            int index = random.Next(count);
            Assert.Equal(values.OrderBy(v => v).ElementAt(index), InPlaceOrder.Nth([.. values], count, index));
            float[] keys = [.. values.Select(v => (float)v)];
            int[] indices = [.. Enumerable.Range(0, count)];
            InPlaceOrder.SortDescending(keys, indices, count);
            Assert.Equal(values.OrderByDescending(v => v).Select(v => (float)v), keys);
            Assert.Equal(keys, indices.Select(i => (float)values[i]));
        }
    }
}
