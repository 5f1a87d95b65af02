using System;
using System.Reflection;
using Xunit;

namespace Rabit.Mavlink.Tests.Messages;

public class AllocationTests
{
    [Fact]
    public void DecodeEncode_EveryMessage_AllocatesNothing()
    {
        MethodInfo measure = typeof(AllocationTests).GetMethod(nameof(Measure), BindingFlags.NonPublic | BindingFlags.Static)!;
        foreach (Type type in MessageTypes.ById.Values)
            Assert.Equal(0L, measure.MakeGenericMethod(type).Invoke(null, null));
    }

    private static long Measure<T>()
        where T : struct, IMavlinkMessage
    {
        var payload = new byte[255];
        var message = default(T);
        long before = 0;
        // The first rounds let the runtime load what it needs.
        for (int round = 0; round < 10; round++)
        {
            if (round == 5)
                before = GC.GetAllocatedBytesForCurrentThread();
            message.Decode(payload);
            message.Encode(payload);
        }

        return GC.GetAllocatedBytesForCurrentThread() - before;
    }
}
