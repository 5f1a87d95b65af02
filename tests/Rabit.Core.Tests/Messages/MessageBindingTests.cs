using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Rabit.Core.Messages;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Messages;

/// <summary>Contract 2.6: handlers that are added while the endpoint is wired.</summary>
public sealed class MessageBindingTests
{
    private static readonly TimeSpan MaxDuration = TimeSpan.FromSeconds(2);

    [Fact, Trait("Clause", "2.6"), Trait("Category", "Stress")]
    public void AddHandler_WhileItIsWired_JoinsEachHandlerOnce()
    {
        const int Rounds = 3000;
        int unordered = 0;
        var watch = Stopwatch.StartNew();
        using var barrier = new Barrier(2);
        for (int round = 0; round < Rounds && watch.Elapsed < MaxDuration; round++)
        {
            MessageBinding<int> binding = NewBinding();
            var shared = new SharedValue<int>(MessagePlaces.New("height"), initial: 0, isAlone: true);
            var calls = new List<int>();
            int added = 0;
            for (; added < 20; added++)
                Add(binding, calls, added);

            var adder = new Thread(() =>
            {
                barrier.SignalAndWait(TestTimeout.Limit);
                for (int more = 0; more < 60; more++)
                    Add(binding, calls, added++);
            });
            adder.Start();
            barrier.SignalAndWait(TestTimeout.Limit);
            Thread.SpinWait(round % 100);
            binding.Bind(shared, firstOfOwner: null);
            Assert.True(adder.Join(TestTimeout.Limit));

            shared.Post(shared.CreateCopy(), new EndpointOwner("poster", true, new WakeUpEvent()), TimeSpan.Zero);
            int[] expected = Enumerable.Range(0, added).ToArray();
            Assert.Equal(expected, calls.OrderBy(c => c));
            if (!calls.SequenceEqual(expected))
                unordered++;
        }

        // Those of one thread are called in the order in which it has added them.
        Assert.Equal(0, unordered);
    }

    private static void Add(MessageBinding<int> binding, List<int> calls, int number)
        => binding.AddHandler(_ => calls.Add(number));

    private static MessageBinding<int> NewBinding()
        => new(new EndpointOwner("outside", isManager: false, wakeUp: null), EndpointRole.Subscribe, "height");
}
