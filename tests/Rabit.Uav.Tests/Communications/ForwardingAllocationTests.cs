using System;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

public sealed class ForwardingAllocationTests
{
    [Fact]
    public void Forwarding_SteadyState_AllocatesNothing()
    {
        var autopilot = new FakeAutopilot(1024) { Keeps = false };
        using CommunicationsRig rig = new CommunicationsRig(links: 2, autopilot: autopilot).As(1);
        // A whole circle of sequence numbers: what is the same sooner is a copy, and not forwarded.
        byte[][] bursts = Enumerable.Range(0, 16).Select(
            b => Frames.Join(Enumerable.Range(0, 16).Select(n => Frames.Heartbeat(sequence: (byte)((b * 16) + n)))))
            .ToArray();
        var received = new byte[bursts[0].Length];
        int next = 0;
        Forward(500);

        Assert.Equal(0, Allocated.By(() => Forward(500)));

        void Forward(int times)
        {
            for (int n = 0; n < times; n++)
            {
                byte[] bytes = bursts[next++ % bursts.Length];
                rig.Far(0).Write(bytes, 0, bytes.Length);
                rig.Run(TimeSpan.FromMilliseconds(10));
                if (rig.Far(1).Read(received).Count != bytes.Length)
                    throw new InvalidOperationException("not all was forwarded");
            }
        }
    }
}
