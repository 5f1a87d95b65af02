using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;

namespace Rabit.Core.RealTimeKit;

/// <summary>
/// Asks the operating system for what a manager requested, on the manager's thread, and reports the outcome. One of a
/// run.
/// </summary>
/// <param name="log">Every part is a note in it.</param>
/// <param name="control">The operating system; null where there is nothing to ask.</param>
/// <param name="unavailable">Why there is nothing to ask.</param>
internal sealed class RealTimeSetup(RabitLog log, IThreadControl? control, string unavailable)
{
    private const string OnlyLinux = "only Linux has it";

    private readonly SpinGuard _spinGuard = new();
    private IReadOnlyList<int>? _allCpus;   // read once, before the first thread is pinned

    /// <summary>For threads of this machine.</summary>
    public static RealTimeSetup ForThreads(RabitLog log)
        => new(log, OperatingSystem.IsLinux() ? new LinuxThreadControl() : null, OnlyLinux);

    /// <summary>
    /// Called on the thread of an activity before anything of it; managers begin one after the other.
    /// </summary>
    public void Apply(Activity activity)
    {
        if (activity is not ManagerActivity { Manager: { RealTimeRequest: { } request } manager })
            return;
        var grants = new List<RealTimeGrant>();
        try
        {
            AskFor(request, manager, grants);
        }
        catch (Exception e) when (e is DllNotFoundException or EntryPointNotFoundException)
        {
            grants.Add(new RealTimeGrant("the calls of libc", ExceptionText.MessageOf(e)));
        }

        manager.RealTimeReport = new RealTimeReport(grants);
        foreach (RealTimeGrant grant in grants)
            log.Write(RabitLogKind.Note, activity.Name, "real time: " + grant);
    }

    private void AskFor(RealTimeRequest request, RabitManager manager, List<RealTimeGrant> grants)
    {
        if (request.WarmUpRuns > 0)
            grants.Add(control is null ? Refuse(WarmUpText(request)) : WarmUp(manager, request));
        if (request.LocksMemory)
            grants.Add(Ask("memory locked", c => c.LockMemory(), NeedsToLock));
        if (request.TimerSlack is { } slack)
            grants.Add(
                Ask(Text($"timer slack {slack.Ticks / 10.0} µs"), c => c.SetTimerSlack(slack.Ticks * 100), _ => null));

        // The CPUs before the priority: it is judged by them. The priority last: all else is done at an ordinary one.
        if (request.Cpus.Count > 0)
            grants.Add(Pin(request.Cpus));
        if (request.Priority is { } priority)
            grants.Add(Raise(request, priority));
    }

    private RealTimeGrant Refuse(string requested) => new(requested, unavailable);

    private RealTimeGrant Ask(string requested, Func<IThreadControl, int> call, Func<int, string?> help)
    {
        if (control is null)
            return Refuse(requested);
        int error = call(control);
        if (error == 0)
            return new RealTimeGrant(requested, reason: null);
        string? needs = help(error);
        return new RealTimeGrant(requested, SystemErrors.Name(error) + (needs is null ? string.Empty : ": " + needs));
    }

    private RealTimeGrant Pin(IReadOnlyList<int> cpus)
    {
        _allCpus ??= control?.Cpus;
        string requested = "CPUs " + string.Join(", ", cpus);
        RealTimeGrant grant = Ask(requested, c => c.SetCpus(cpus), NeedsForCpus);

        // The kernel leaves out, in silence, those that the process may not use.
        if (!grant.IsGranted || control!.Cpus is not { } own || own.SequenceEqual(cpus))
            return grant;
        return new RealTimeGrant(requested, "the process may use only " + string.Join(", ", own) + " of them");
    }

    private RealTimeGrant Raise(RealTimeRequest request, int priority)
    {
        string requested = Text(
            $"priority {(request.Policy == RealTimePolicy.Fifo ? "FIFO" : "round robin")} {priority}");
        if (control is null)
            return Refuse(requested);
        bool throttles = control.ThrottlesRealTime;
        _allCpus ??= control.Cpus;
        if ((request.Spins || !throttles) && !_spinGuard.TryAdmit(control.Cpus, _allCpus))
        {
            return new RealTimeGrant(
                requested, "refused by Rabit: threads that may spin at real-time priority could occupy every CPU"
                    + (throttles ? string.Empty : " (the kernel's throttling is off, so every one may)"));
        }

        return Ask(requested, c => c.SetPriority(request.Policy, priority), error => NeedsForPriority(error, priority));
    }

    private static RealTimeGrant WarmUp(RabitManager manager, RealTimeRequest request)
    {
        string requested = WarmUpText(request);
        try
        {
            Compile(manager.GetType());
            for (int i = 0; i < request.WarmUpRuns; i++)
                manager.RunWarmUp();
            return new RealTimeGrant(requested, reason: null);
        }
        catch (Exception e)
        {
            // The user's code: it goes to the report, since nothing of the manager has begun yet.
            return new RealTimeGrant(requested, ExceptionText.Describe(e));
        }
    }

    // Without running anything. What the class does not have any more after trimming is not called either.
    [UnconditionalSuppressMessage("Trimming", "IL2070",
        Justification = "Only methods that are there are compiled ahead.")]
    [UnconditionalSuppressMessage("Trimming", "IL2075",
        Justification = "Only methods that are there are compiled ahead.")]
    private static void Compile(Type type)
    {
        const BindingFlags Own = BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public
            | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        for (Type? level = type; level is not null && level != typeof(RabitManager); level = level.BaseType)
        {
            if (level.ContainsGenericParameters || level.IsGenericType)
                continue;
            foreach (MethodInfo method in level.GetMethods(Own))
            {
                if (!method.IsAbstract && !method.ContainsGenericParameters)
                    RuntimeHelpers.PrepareMethod(method.MethodHandle);
            }
        }
    }

    private static string WarmUpText(RealTimeRequest request) => Text($"warm-up {request.WarmUpRuns} runs");

    private static string? NeedsForPriority(int error, int priority) => error == SystemErrors.NotPermitted
        ? Text($"it needs CAP_SYS_NICE or a limit of real-time priority (ulimit -r) of at least {priority}")
        : null;

    private static string? NeedsToLock(int error) => error switch
    {
        SystemErrors.NotPermitted => "it needs CAP_IPC_LOCK or a limit of locked memory (ulimit -l) above zero",
        SystemErrors.OutOfMemory =>
            "the limit of locked memory (ulimit -l) is below what the process reserves; it needs CAP_IPC_LOCK or "
                + "'unlimited'",
        _ => null,
    };

    private static string? NeedsForCpus(int error)
        => error == SystemErrors.Invalid ? "the process may use none of them" : null;

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
