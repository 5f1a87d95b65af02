using System;
using System.Threading;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;

namespace Rabit.Core.Reactors;

/// <summary>
/// The last catch of every thread of the library: what leaves a thread would end the process. User code is guarded
/// where it is called, so what comes here is unexpected: a clock of the user's that throws, an interrupt while the
/// library waits for a lock of its own, a defect of the library. It ends the activity, not the process, and is in the
/// result.
/// </summary>
internal static class LastResort
{
    /// <summary>Instead of all further steps and the end of an activity. Never throws.</summary>
    /// <param name="activity">What cannot continue.</param>
    /// <param name="unexpected">What left it.</param>
    /// <param name="fail">Fails the run, where the activity itself has no place for the fault.</param>
    public static void End(Activity activity, Exception unexpected, Action<Exception> fail)
        => DespiteInterrupts(() =>
        {
            try
            {
                if (!TryEndAfter(activity, ref unexpected))
                    fail(new InvalidOperationException(
                        $"{activity.Name} ended unexpectedly: {ExceptionText.Describe(unexpected)}", unexpected));
            }
            catch (Exception e) when (e is not ThreadInterruptedException)
            {
                // The run has the fault already, and could not be stopped; the process must go on all the same.
            }
        });

    /// <summary>
    /// Does something that takes locks, again if <see cref="Thread.Interrupt"/> ends the wait for one: an interrupt is
    /// over when it has been thrown.
    /// </summary>
    public static void DespiteInterrupts(Action action)
    {
        while (true)
        {
            try
            {
                action();
                return;
            }
            catch (ThreadInterruptedException)
            {
                // It is for no one: the thread is the library's.
            }
        }
    }

    private static bool TryEndAfter(Activity activity, ref Exception unexpected)
    {
        try
        {
            return activity.TryEndAfter(unexpected);
        }
        catch (Exception again) when (again is not ThreadInterruptedException)
        {
            // Even its end did not work: the run itself reports it.
            unexpected = again;
            return false;
        }
    }
}
