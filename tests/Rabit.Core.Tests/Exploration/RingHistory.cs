using System;
using Rabit.Core.Queues;

namespace Rabit.Core.Tests.Exploration;

/// <summary>What was pushed, popped and counted so far, and the checks of contract 3.1 and 3.2.</summary>
/// <remarks>
/// A call counts from its first step to its last, so that what is asked for is true wherever in between it took effect.
/// The values of a sender are numbered without a gap: what was rejected is pushed again.
/// </remarks>
internal sealed class RingHistory(RingScenario scenario)
{
    private const int IsPopping = 0;
    private const int MustFind = 1;     // how many values a pop has to find
    private const int MustCount = 2;    // how many pushes and pops a look at the counters has to find
    private const int MustCountPopped = 3;
    private const int PerRun = 4;

    // For each sender: values that are in, those of a push under way, and those taken out; how many had been taken out
    // when its push began.
    private const int Accepted = 0;
    private const int Offered = 1;
    private const int Popped = 2;
    private const int PoppedBefore = 3;
    private const int Each = 4;

    private readonly int _senders = scenario.Pushes.Count;

    public int Size => PerRun + (_senders * Each);

    public static int Value(int sender, int number) => ((sender + 1) << 8) + number;

    public void CallPush(ExploredState s, int sender)
    {
        s.Note(Of(sender, Offered)) = scenario.Batch;
        s.Note(Of(sender, PoppedBefore)) = Sum(s, Popped);
    }

    public void ReturnPush(ExploredState s, int sender, int accepted)
    {
        s.Note(Of(sender, Offered)) = 0;
        s.Note(Of(sender, Accepted)) += accepted;
        int inIt = Sum(s, Accepted);
        s.Require(
            inIt - Sum(s, Popped) - (s.Note(IsPopping) * scenario.Batch) <= scenario.Capacity,
            "more values are in the queue than its capacity");
        s.Require(
            !scenario.IsSeenAtOnce || accepted == scenario.Batch
                || inIt + Sum(s, Offered) - s.Note(Of(sender, PoppedBefore)) >= scenario.Capacity,
            "a push was rejected though there was room");
        s.Note(Of(sender, PoppedBefore)) = 0;
    }

    public void CallPop(ExploredState s)
    {
        s.Note(IsPopping) = 1;

        // A sender that is held up in a push holds up what others push after it.
        s.Note(MustFind) = scenario.IsSeenAtOnce && _senders == 1 ? Sum(s, Accepted) - Sum(s, Popped) : 0;
    }

    public void Pop(ExploredState s, int value)
    {
        int sender = (value >> 8) - 1;
        s.Require(sender >= 0 && sender < _senders, $"a value was popped before it was there: {value}");
        if (sender < 0 || sender >= _senders)
            return;
        ref int popped = ref s.Note(Of(sender, Popped));
        popped++;
        s.Require(popped == (value & 0xFF), $"value {value & 0xFF} of a sender was popped as its number {popped}");
        s.Require(
            popped <= s.Note(Of(sender, Accepted)) + s.Note(Of(sender, Offered)), "a value was popped twice");
    }

    public void ReturnPop(ExploredState s, int count)
    {
        s.Require(
            count >= Math.Min(s.Note(MustFind), scenario.Batch), "a pop missed a value whose push had returned");
        s.Note(IsPopping) = 0;
        s.Note(MustFind) = 0;
    }

    public void CallLook(ExploredState s)
    {
        if (!scenario.IsSeenAtOnce)
            return;
        s.Note(MustCount) = Sum(s, Accepted);
        s.Note(MustCountPopped) = Sum(s, Popped);
    }

    public void ReturnLook(ExploredState s, in QueueCounters counters)
    {
        s.Require(
            counters.Pushed >= s.Note(MustCount) && counters.Pushed <= Sum(s, Accepted) + Sum(s, Offered),
            $"{counters.Pushed} pushes are counted");
        s.Require(
            counters.Popped >= s.Note(MustCountPopped)
                && counters.Popped <= Sum(s, Popped) + (s.Note(IsPopping) * scenario.Batch),
            $"{counters.Popped} pops are counted");
        s.Require(
            counters.Resident >= 0 && counters.Resident <= scenario.Capacity
                && counters.Resident == counters.Pushed - counters.Popped,
            $"{counters.Resident} values are counted as in the queue");
        s.Note(MustCount) = 0;
        s.Note(MustCountPopped) = 0;
    }

    private int Sum(ExploredState s, int note)
    {
        int sum = 0;
        for (int sender = 0; sender < _senders; sender++)
            sum += s.Note(Of(sender, note));
        return sum;
    }

    private static int Of(int sender, int note) => PerRun + (sender * Each) + note;
}
