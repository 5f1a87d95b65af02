using System;
using System.Reflection;

namespace Rabit.Core.Reactors;

/// <summary>The stop signals of .NET 6.0 and later: PosixSignalRegistration, by reflection.</summary>
internal sealed class PosixStopSignals : IDisposable
{
    private const string Library = "System.Runtime.InteropServices";

    // Members of the enum PosixSignal, the same on every system.
    private const int SignalHangUp = -1;
    private const int SignalInterrupt = -2;
    private const int SignalTerminate = -4;

    private readonly IDisposable[] _registrations;

    private PosixStopSignals(params IDisposable[] registrations) => _registrations = registrations;

    /// <returns>Null where the runtime has no PosixSignalRegistration.</returns>
    public static PosixStopSignals? TryCreate(Action<string> stop)
    {
        Type? registration = Type.GetType($"{Library}.PosixSignalRegistration, {Library}");
        Type? signal = Type.GetType($"{Library}.PosixSignal, {Library}");
        PropertyInfo? cancel = Type.GetType($"{Library}.PosixSignalContext, {Library}")?.GetProperty("Cancel");
        if (registration is null || signal is null || cancel is null)
            return null;

        Type handler = typeof(Action<>).MakeGenericType(cancel.DeclaringType!);
        return registration.GetMethod("Create", [signal, handler]) is { } create
            ? new PosixStopSignals(
                Register(SignalInterrupt, "Ctrl-C"), Register(SignalTerminate, "SIGTERM"),
                Register(SignalHangUp, "SIGHUP"))
            : null;

        IDisposable Register(int number, string name)
        {
            var target = new Handler(cancel, name, stop);
            Delegate call = Delegate.CreateDelegate(
                handler, target, typeof(Handler).GetMethod(nameof(Handler.OnSignal))!);
            return (IDisposable)create.Invoke(null, [Enum.ToObject(signal, number), call])!;
        }
    }

    public void Dispose()
    {
        foreach (IDisposable registration in _registrations)
            registration.Dispose();
    }

    private sealed class Handler(PropertyInfo cancel, string name, Action<string> stop)
    {
        public void OnSignal(object context)
        {
            // The run ends in order instead of the process at once.
            cancel.SetValue(context, true);
            stop(name);
        }
    }
}
