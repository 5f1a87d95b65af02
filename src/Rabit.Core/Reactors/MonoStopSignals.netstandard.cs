using System;
using System.Reflection;
using System.Threading;

namespace Rabit.Core.Reactors;

/// <summary>The stop signals of Mono: UnixSignal of Mono.Posix, by reflection, on a thread that polls it.</summary>
internal sealed class MonoStopSignals : IDisposable
{
    private const int SignalInterrupt = 2;
    private const int SignalTerminate = 15;
    private const int PollMilliseconds = 200;
    private const string UnixSignal =
        "Mono.Unix.UnixSignal, Mono.Posix, Version=4.0.0.0, Culture=neutral, PublicKeyToken=0738eb9f132ed756";

    private readonly Action<string> _stop;
    private readonly Array _signals;
    private readonly MethodInfo _waitAny;
    private readonly PropertyInfo _isSet;
    private int _isDisposed;   // set by Dispose, read by the signal thread

    private MonoStopSignals(Action<string> stop, Array signals, MethodInfo waitAny, PropertyInfo isSet)
    {
        _stop = stop;
        _signals = signals;
        _waitAny = waitAny;
        _isSet = isSet;
        new Thread(Listen) { Name = "stop signals", IsBackground = true }.Start();
    }

    /// <returns>Null where this is not Mono, or Mono.Posix is absent.</returns>
    public static MonoStopSignals? TryCreate(Action<string> stop)
    {
        if (Type.GetType("Mono.Runtime") is null)
            return null;
        Type? type = Type.GetType(UnixSignal);
        Type? number = type?.Assembly.GetType("Mono.Unix.Native.Signum");
        if (type is null || number is null)
            return null;

        Array signals = Array.CreateInstance(type, 2);
        try
        {
            signals.SetValue(Activator.CreateInstance(type, Enum.ToObject(number, SignalInterrupt)), 0);
            signals.SetValue(Activator.CreateInstance(type, Enum.ToObject(number, SignalTerminate)), 1);
        }
        catch (TargetInvocationException)
        {
            // The native helper of Mono.Posix is missing.
            return null;
        }

        return type.GetMethod("WaitAny", [signals.GetType(), typeof(int)]) is { } waitAny
            && type.GetProperty("IsSet") is { } isSet
            ? new MonoStopSignals(stop, signals, waitAny, isSet)
            : null;
    }

    public void Dispose() => Interlocked.Exchange(ref _isDisposed, 1);

    private void Listen()
    {
        object[] arguments = [_signals, PollMilliseconds];
        while (Volatile.Read(ref _isDisposed) == 0)
        {
            // A wait ends only by a signal that comes while it lasts; one that came before it is found by IsSet.
            _waitAny.Invoke(null, arguments);
            int index = Array.FindIndex((object[])_signals, signal => (bool)_isSet.GetValue(signal)!);
            if (index >= 0)
            {
                _stop(index == 0 ? "Ctrl-C" : "SIGTERM");
                break;
            }
        }

        foreach (object signal in _signals)
            ((IDisposable)signal).Dispose();
    }
}
