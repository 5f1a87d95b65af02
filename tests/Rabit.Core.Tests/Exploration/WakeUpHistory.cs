using System;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// What was called, what returned and what the turns took, as far as a check still asks for it, and these checks.
/// </summary>
/// <remarks>
/// A wake counts as called with the first step of its call and as returned with the last: the sharpest that can be
/// asked for. A number that can only be compared in one way from now on becomes 0, so that states which differ in
/// nothing that matters are one.
/// </remarks>
internal sealed class WakeUpHistory(WakeUpScenario scenario)
{
    private const int IsOver = 0;
    private const int Taken = 1;
    private const int StartCalled = 2;
    private const int StartReturned = 3;
    private const int StopCalled = 4;
    private const int StopReturned = 5;
    private const int HasRun = 6;
    private const int PerWaker = 7;

    // For each waker: wakes called and returned, the same when the last turn began, the number that the last turn saw,
    // and what its reads must see.
    private const int Called = 0;
    private const int Returned = 1;
    private const int CalledBefore = 2;
    private const int ReturnedBefore = 3;
    private const int Seen = 4;
    private const int MustSee = 5;
    private const int Each = 6;

    private static readonly WakeUpCauses[] Causes =
        [WakeUpCauses.Post, WakeUpCauses.Push, WakeUpCauses.Request, WakeUpCauses.Pop];

    public int Size => PerWaker + (scenario.Wakers * Each);

    public static WakeUpCauses CauseOf(int waker) => Causes[waker];

    public static void CallStart(ExploredState s) => Set(s, StartCalled, 1);

    public static void ReturnStart(ExploredState s) => Set(s, StartReturned, 1);

    public static void CallStop(ExploredState s) => Set(s, StopCalled, 1);

    public static void ReturnStop(ExploredState s) => Set(s, StopReturned, 1);

    public static void Call(ExploredState s, int waker, int number)
    {
        Set(s, Of(waker, Called), number);
        Set(s, Of(waker, ReturnedBefore), 0);   // less than what is called, from now on
    }

    public static void Return(ExploredState s, int waker, int number)
    {
        Set(s, Of(waker, Returned), number);
        if (s.Note(Of(waker, CalledBefore)) < number)
            Set(s, Of(waker, CalledBefore), 0);   // the same: less than what has returned
        if (s.Note(Of(waker, Seen)) < number)
            Set(s, Of(waker, Seen), 0);
    }

    /// <summary>
    /// A turn begins: it has all wakes that have returned, none that was not called, and their causes.
    /// </summary>
    public void BeginStep(ExploredState s, NextStep planned, ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        bool isTimer = (wakes.Causes & WakeUpCauses.Timer) != 0;
        bool isWanted = (planned.Wanted & (int)WakeUpCauses.Post) != 0 || (wakes.Causes & WakeUpCauses.Start) != 0;
        s.Require(s.Note(StopReturned) == 0, "a turn began after a stop had returned");
        bool isAfterRestart = scenario.Restarts && (wakes.Causes & WakeUpCauses.Start) != 0;
        s.Require(isTimer || wakes.Count > 0 || isAfterRestart, "a turn without a cause");
        Set(s, HasRun, scenario.Restarts ? 1 : 0);
        s.Require(!isTimer || s.Now >= planned.Due, "a timer came early");
        s.Require(wokenAt is null || wokenAt <= s.Now, "a wake is said to have come later than now");
        s.Require(isWanted || isTimer, "a wake ended a sleep that it should not");
        int taken = s.Note(Taken) += wakes.Count;
        s.Require(
            !scenario.ChecksCounts || taken >= s.Note(StartReturned) + Sum(s, Returned),
            "a wake that had returned is not in the turn");
        s.Require(taken <= s.Note(StartCalled) + Sum(s, Called), "a wake is in two turns");
        for (int waker = 0; waker < scenario.Wakers; waker++)
            BeginStep(s, waker, (wakes.Causes & Causes[waker]) != 0);
    }

    /// <summary>The turn reads what a waker wrote plainly.</summary>
    public static void See(ExploredState s, int waker, int seen)
    {
        s.Require(seen >= s.Note(Of(waker, MustSee)), "a turn does not see what was written before its wake");
        Set(s, Of(waker, Seen), seen < s.Note(Of(waker, Returned)) ? 0 : seen);
        Set(s, Of(waker, MustSee), 0);
    }

    /// <summary>The sleeper has ended: nothing of this matters any more.</summary>
    public void End(ExploredState s)
    {
        s.Require(s.Note(StopCalled) != 0, "the sleeper ended, and was not stopped");
        for (int note = 0; note < Size; note++)
            s.Note(note) = 0;
        s.Note(IsOver) = 1;
    }

    /// <summary>What must hold when nothing goes on without the timer.</summary>
    public void CheckQuiet(ExploredState s)
    {
        s.Require(s.Note(StopReturned) == 0 || s.Note(IsOver) != 0, "a stop was lost: the sleeper goes on sleeping");

        // A sleeper that backs off, or is at the barrier, keeps its wakes; that they are all in its next turn is
        // checked there.
        bool isAtBarrier = scenario.Stops && !scenario.Starts && !scenario.Restarts;
        bool isRestarting = scenario.Restarts && s.Note(HasRun) == 0;
        if (s.Note(IsOver) != 0 || scenario.BacksOff || isRestarting || isAtBarrier)
            return;
        s.Require(
            !scenario.ChecksCounts || s.Note(Taken) == s.Note(StartReturned) + Sum(s, Returned),
            "a wake was lost: the sleeper goes on sleeping");
        for (int waker = 0; waker < scenario.Wakers; waker++)
            s.Require(
                s.Note(Of(waker, Seen)) == s.Note(Of(waker, Returned)),
                "a post was lost: the last turn saw an older one");
    }

    private void BeginStep(ExploredState s, int waker, bool isCause)
    {
        int called = s.Note(Of(waker, Called));
        int returned = s.Note(Of(waker, Returned));
        s.Require(
            !scenario.ChecksCounts || isCause || returned <= s.Note(Of(waker, CalledBefore)),
            "a wake is in the turn, but not its cause");
        s.Require(!isCause || called > s.Note(Of(waker, ReturnedBefore)), "a cause is in the turn, but not its wake");
        s.Note(Of(waker, CalledBefore)) = called;
        s.Note(Of(waker, ReturnedBefore)) = called > returned ? 0 : returned;
        s.Note(Of(waker, MustSee)) = returned;
    }

    private int Sum(ExploredState s, int note)
    {
        int sum = 0;
        for (int waker = 0; waker < scenario.Wakers; waker++)
            sum += s.Note(Of(waker, note));
        return sum;
    }

    private static int Of(int waker, int note) => PerWaker + (waker * Each) + note;

    private static void Set(ExploredState s, int note, int value)
    {
        if (s.Note(IsOver) == 0)
            s.Note(note) = value;
    }
}
