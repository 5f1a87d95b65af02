using System;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Threading;

namespace Rabit.Core.Reactors;

/// <summary>The stop signals of Mono: UnixSignal of Mono.Posix, by reflection, on a thread that polls it.</summary>
internal sealed class MonoStopSignals : IDisposable
{
    private const int HangUp = 1;
    private const int PollMilliseconds = 200;
    private const string UnixSignal =
        "Mono.Unix.UnixSignal, Mono.Posix, Version=4.0.0.0, Culture=neutral, PublicKeyToken=0738eb9f132ed756";

    // Members of the enum Signum, and what each is called in the result.
    private static readonly (int Number, string Name)[] Stops = [(2, "Ctrl-C"), (15, "SIGTERM"), (HangUp, "SIGHUP")];

    private readonly Action<string> _stop;
    private readonly Array _signals;
    private readonly MethodInfo _waitAny;
    private readonly PropertyInfo _isSet;
    private readonly MethodInfo _reset;
    private int _isDisposed;   // set by Dispose, read by the signal thread

    private MonoStopSignals(
        Action<string> stop, Array signals, MethodInfo waitAny, PropertyInfo isSet, MethodInfo reset)
    {
        _stop = stop;
        _signals = signals;
        _waitAny = waitAny;
        _isSet = isSet;
        _reset = reset;
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

        // What nohup has the process ignore stays ignored, as .NET leaves it. It is the last one of the three.
        Array signals = Array.CreateInstance(type, IgnoresHangUp() ? Stops.Length - 1 : Stops.Length);
        try
        {
            for (int i = 0; i < signals.Length; i++)
                signals.SetValue(Activator.CreateInstance(type, Enum.ToObject(number, Stops[i].Number)), i);
        }
        catch (TargetInvocationException)
        {
            // The native helper of Mono.Posix is missing.
            return null;
        }

        return type.GetMethod("WaitAny", [signals.GetType(), typeof(int)]) is { } waitAny
            && type.GetProperty("IsSet") is { } isSet
            && type.GetMethod("Reset", []) is { } reset
            ? new MonoStopSignals(stop, signals, waitAny, isSet, reset)
            : null;
    }

    public void Dispose() => Interlocked.Exchange(ref _isDisposed, 1);

    // Bit 0 of the mask of ignored signals is that of SIGHUP (man 5 proc).
    private static bool IgnoresHangUp()
    {
        const string Status = "/proc/self/status";
        try
        {
            string? mask = File.Exists(Status)
                ? File.ReadLines(Status).FirstOrDefault(l => l.StartsWith("SigIgn:", StringComparison.Ordinal))
                : null;
            return mask is not null && "13579bdfBDF".IndexOf(mask[mask.Length - 1]) >= 0;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    private void Listen()
    {
        try
        {
            WaitForSignal();
        }
        catch (Exception)
        {
            // The last resort of this thread: a run without stop signals is better than a process that ends.
        }
    }

    private void WaitForSignal()
    {
        object[] arguments = [_signals, PollMilliseconds];
        while (Volatile.Read(ref _isDisposed) == 0)
        {
            // A wait ends only by a signal that comes while it lasts; one that came before it is found by IsSet.
            _waitAny.Invoke(null, arguments);
            int index = Array.FindIndex((object[])_signals, signal => (bool)_isSet.GetValue(signal)!);
            if (index < 0)
                continue;

            // Taken, and others may follow: a second one ends the delay of a stop.
            _reset.Invoke(_signals.GetValue(index), null);
            _stop(Stops[index].Name);
        }

        foreach (object signal in _signals)
            ((IDisposable)signal).Dispose();
    }
}
