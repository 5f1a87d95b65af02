using System;
using System.Threading;
using Rabit.Core.Managers;

namespace Rabit.Core;

/// <content>What a manager has to do with the stop of the run: it asks for it, learns of it, and delays it.</content>
public abstract partial class RabitManager
{
    private bool _delaysStop;     // the manager's thread only, and the reactor's before the start
    private bool _isDelaying;     // whether it counts; written by the same, read by the reactor
    private bool _isHalted;       // the manager's thread only: a fault ended its units of work

    /// <summary>
    /// Whether a stop of the run was requested, by a signal, a call, or the policy for a fault or a hang of any
    /// manager. Once true it stays true. Any thread.
    /// </summary>
    /// <value>False before the start.</value>
    protected bool IsStopRequested => _run?.StopDelay?.IsRequested ?? false;

    /// <summary>
    /// Whether a requested stop waits for this manager: for something that must be in order before the program may end.
    /// While any manager delays a requested stop, all managers continue with their units of work, and each is woken
    /// once with <see cref="WakeUpCauses.StopRequested"/>.
    /// </summary>
    /// <remarks>
    /// <para>Set it before the stop is requested, when what would have to be finished begins, and set it back when it
    /// is finished. One that is set when the stop has been requested, and no other manager delays it, comes too late;
    /// after setting it, <see cref="IsStopRequested"/> false means that it was in time. The stop continues when no
    /// manager delays it, when <see cref="ReactorOptions.MaxStopDelay"/> is over, or when a signal or
    /// <see cref="RabitReactor.Stop"/> requests it again; a unit of work in progress then finishes, and none
    /// follows.</para>
    /// <para>It has no effect where <see cref="ReactorOptions.MaxStopDelay"/> is zero, before the start-up barrier
    /// opens, and from the fault on that ended the manager's units of work (<see cref="FaultAction.StopSystem"/>,
    /// <see cref="FaultAction.StopManager"/>). It stays as it is through a fault that the manager carries on or
    /// restarts after, and through a hang.</para>
    /// <para>On the manager's thread, or in its constructor.</para>
    /// </remarks>
    /// <value>The default is false: a stop causes no further unit of work.</value>
    /// <exception cref="InvalidOperationException">Set on another thread than the manager's.</exception>
    /// <example>
    /// <code>
    /// public sealed class Gripper : RabitManager
    /// {
    ///     private readonly QueueReceiver&lt;bool&gt; _commands;   // true: close, false: open
    ///
    ///     public Gripper() : base("gripper") => _commands = Receive&lt;bool&gt;("gripper commands");
    ///
    ///     protected override void ExecuteUnitOfWork()
    ///     {
    ///         while (_commands.TryPop(out bool closes))
    ///             DelaysStop = closes;          // what is held must be put down first
    ///         if (IsStopRequested &amp;&amp; DelaysStop)
    ///         {
    ///             PutDown();                    // may take several units of work
    ///             DelaysStop = false;           // the stop continues
    ///         }
    ///     }
    ///
    ///     private void PutDown()
    ///     {
    ///     }
    /// }
    /// </code>
    /// </example>
    protected bool DelaysStop
    {
        get => _delaysStop;
        set
        {
            if (_run is not null && !RunningManager.Is(_owner))
                ThrowDelayMisuse();
            if (value == _delaysStop || _isHalted)
                return;
            _delaysStop = value;
            SetDelay(value);
        }
    }

    /// <summary>Asks the reactor to stop all managers in order; returns at once. Any thread.</summary>
    /// <param name="reason">For the result of the run.</param>
    /// <remarks>The stop may be delayed (<see cref="DelaysStop"/>); this call ends no delay.</remarks>
    protected void StopSystem(string reason) => Run.RequestStop($"{Name}: {reason}");

    /// <summary>Whether the stop waits for the manager, or waited for it to the last. Any thread.</summary>
    internal bool IsDelaying => Volatile.Read(ref _isDelaying);

    /// <summary>A fault has ended the units of work: a stop waits for the manager no longer.</summary>
    internal void Halt()
    {
        if (_delaysStop)
            SetDelay(delays: false);
        _delaysStop = false;
        _isHalted = true;
    }

    // The mark is set before the manager counts and unset after: who counts is marked. When the run stops, both stay.
    private void SetDelay(bool delays)
    {
        // Before the start there is nothing to count; Attach does it.
        if (_run?.StopDelay is not { } stop)
            return;
        if (delays)
        {
            Volatile.Write(ref _isDelaying, true);
            if (!stop.TrySet(delays: true))
                Volatile.Write(ref _isDelaying, false);
        }
        else if (stop.TrySet(delays: false))
        {
            Volatile.Write(ref _isDelaying, false);
        }
    }

    private void ThrowDelayMisuse()
    {
        string running = RunningManager.Current is { } current ? $"manager '{current.Name}' is" : "no manager is";
        throw new InvalidOperationException(
            $"{nameof(DelaysStop)} belongs to manager '{Name}', but {running} running on this thread.");
    }
}
