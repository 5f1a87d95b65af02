using System;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core;

namespace UavConsole;

/// <summary>
/// Ctrl-C, SIGTERM and SIGHUP for a run whose reactors are in virtual time, which act on no signals: a reactor of its
/// own in real time, with nothing to do, takes them as that of a flight does, on every runtime.
/// </summary>
internal sealed class StopSignal : IDisposable
{
    private readonly CancellationTokenSource _source = new();
    private readonly RabitReactor _reactor = new(new ReactorOptions { Name = "stop signals" }) { new Idle() };
    private readonly Task _run;
    private string? _reason;

    public StopSignal() => _run = _reactor.RunAsync().ContinueWith(
        ended =>
        {
            Volatile.Write(ref _reason, ended.Result.StopReason);
            _source.Cancel();
        },
        CancellationToken.None, TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default);

    /// <summary>Is cancelled when the run is to stop.</summary>
    public CancellationToken Token => _source.Token;

    /// <summary>Why it is to stop: the name of the signal, say; null as long as it is not.</summary>
    public string? Reason => Volatile.Read(ref _reason);

    /// <summary>Asks for the stop as a signal does. Any thread.</summary>
    public void Request(string reason) => _reactor.Stop(reason);

    public void Dispose()
    {
        _reactor.Stop("the run is over");
        _run.Wait();
        _source.Dispose();
    }

    private sealed class Idle : RabitManager
    {
        public Idle()
            : base("idle") => WakeUpDelay = TimeSpan.FromHours(1);

        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
