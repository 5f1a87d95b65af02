using System;
using System.Reflection;
using System.Threading;

namespace Rabit.Core.Reactors;

/// <summary>
/// Ctrl-C and SIGTERM, for the length of one run, where PosixSignalRegistration is missing. On Mono, SIGTERM comes through
/// UnixSignal of Mono.Posix, by reflection, so that nobody needs to ship it. The one file that may touch the console.
/// </summary>
internal sealed class StopSignals : IDisposable
{
    private const int SignalInterrupt = 2;
    private const int SignalTerminate = 15;
    private const int PollMilliseconds = 200;

    private readonly Action<string> _stop;
    private readonly ConsoleCancelEventHandler _onCancelKey;
    private int _isDisposed;   // set by Dispose, read by the signal thread

    public StopSignals(Action<string> stop, Action<string> note)
    {
        _stop = stop;
        _onCancelKey = OnCancelKey;
#pragma warning disable RS0030 // The stop signals are the one exemption from the ban on the console.
        Console.CancelKeyPress += _onCancelKey;
#pragma warning restore RS0030
        if (Type.GetType("Mono.Runtime") is not null && !TryListenToUnixSignals())
            note("Mono.Posix is absent: SIGTERM ends the process without stopping the managers in order");
    }

    public void Dispose()
    {
        Interlocked.Exchange(ref _isDisposed, 1);
#pragma warning disable RS0030 // See above.
        Console.CancelKeyPress -= _onCancelKey;
#pragma warning restore RS0030
    }

    private void OnCancelKey(object? sender, ConsoleCancelEventArgs e)
    {
        e.Cancel = true;
        _stop("Ctrl-C");
    }

    private bool TryListenToUnixSignals()
    {
        Type? type = Type.GetType("Mono.Unix.UnixSignal, Mono.Posix, Version=4.0.0.0, Culture=neutral, PublicKeyToken=0738eb9f132ed756");
        Type? number = type?.Assembly.GetType("Mono.Unix.Native.Signum");
        if (type is null || number is null)
            return false;

        Array signals = Array.CreateInstance(type, 2);
        try
        {
            signals.SetValue(Activator.CreateInstance(type, Enum.ToObject(number, SignalInterrupt)), 0);
            signals.SetValue(Activator.CreateInstance(type, Enum.ToObject(number, SignalTerminate)), 1);
        }
        catch (TargetInvocationException)
        {
            // The native helper of Mono.Posix is missing.
            return false;
        }

        MethodInfo? waitAny = type.GetMethod("WaitAny", [signals.GetType(), typeof(int)]);
        PropertyInfo? isSet = type.GetProperty("IsSet");
        if (waitAny is null || isSet is null)
            return false;
        new Thread(() => Listen(signals, waitAny, isSet)) { Name = "stop signals", IsBackground = true }.Start();
        return true;
    }

    private void Listen(Array signals, MethodInfo waitAny, PropertyInfo isSet)
    {
        object[] arguments = [signals, PollMilliseconds];
        while (Volatile.Read(ref _isDisposed) == 0)
        {
            // A wait ends only by a signal that comes while it lasts; one that came before it is found by asking.
            waitAny.Invoke(null, arguments);
            int index = Array.FindIndex((object[])signals, signal => (bool)isSet.GetValue(signal)!);
            if (index >= 0)
            {
                _stop(index == 0 ? "Ctrl-C" : "SIGTERM");
                break;
            }
        }

        foreach (object signal in signals)
            ((IDisposable)signal).Dispose();
    }
}
