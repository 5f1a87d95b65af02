using System;
using System.Reflection;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Mavlink.Tests.Messages;

public class AllocationTests
{
    [Fact]
    public void DecodeEncode_EveryMessage_AllocatesNothing()
    {
        MethodInfo measure = typeof(AllocationTests).GetMethod(
            nameof(Measure), BindingFlags.NonPublic | BindingFlags.Static)!;
        foreach (Type type in MessageTypes.ById.Values)
            Assert.Equal(0L, measure.MakeGenericMethod(type).Invoke(null, null));
    }

    private static long Measure<T>()
        where T : struct, IMavlinkMessage
    {
        var payload = new byte[255];
        var message = default(T);
        void Rounds()
        {
            for (int round = 0; round < 5; round++)
            {
                message.Decode(payload);
                message.Encode(payload);
            }
        }

        // The first rounds let the runtime load what it needs.
        Rounds();
        return Allocated.By(Rounds);
    }
}
