using System.Diagnostics.Tracing;

namespace Rabit.Core.Diagnostics;

/// <summary>
/// The event source "Rabit-Core", for dotnet-trace, PerfView and listeners in the process: the entries of the logs of
/// all runs, and, verbose, each unit of work. It costs a flag while no listener is attached.
/// </summary>
/// <remarks>
/// An event source is registered once in a process, by its name, so it is the one static instance here; it holds
/// nothing of any run.
/// </remarks>
[EventSource(Name = "Rabit-Core")]
internal sealed class RabitEventSource : EventSource
{
    public static readonly RabitEventSource Instance = new();

    private RabitEventSource()
    {
    }

    [NonEvent]
    public void Entry(RabitLogKind kind, string source, string text)
    {
        switch (kind)
        {
            case RabitLogKind.Fault:
                Fault(source, text);
                break;
            case RabitLogKind.Hang:
                Hang(source, text);
                break;
            case RabitLogKind.Lifecycle:
                Lifecycle(source, text);
                break;
            case RabitLogKind.Run:
                break;
            default:
                Note(source, text);
                break;
        }
    }

    [Event(1, Level = EventLevel.Error)]
    public void Fault(string source, string text) => WriteEvent(1, source, text);

    [Event(2, Level = EventLevel.Error)]
    public void Hang(string manager, string text) => WriteEvent(2, manager, text);

    [Event(3, Level = EventLevel.Informational)]
    public void Lifecycle(string source, string text) => WriteEvent(3, source, text);

    [Event(4, Level = EventLevel.Informational)]
    public void Note(string source, string text) => WriteEvent(4, source, text);

    [Event(5, Level = EventLevel.Verbose)]
    public void UnitOfWork(string manager, int microseconds, int wakeLatencyMicroseconds)
        => WriteEvent(5, manager, microseconds, wakeLatencyMicroseconds);
}
