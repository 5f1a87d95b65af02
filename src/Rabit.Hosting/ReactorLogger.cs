using System;
using System.Collections.Concurrent;
using Microsoft.Extensions.Logging;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>
/// The log of a reactor in the log of the host: a category for each manager, an event id for each kind of entry, the
/// reactor's time in the scope. Any thread.
/// </summary>
internal sealed class ReactorLogger(ILoggerFactory factory, string reactor)
{
    private readonly ConcurrentDictionary<string, ILogger> _loggers = new(StringComparer.Ordinal);

    public void Write(RabitLogEntry entry)
    {
        ILogger logger = LoggerOf(entry.Source);
        LogLevel level = LevelOf(entry.Kind);
        if (!logger.IsEnabled(level))
            return;
        using (logger.BeginScope(new ReactorScope(reactor, entry.Time)))
        {
            logger.Log(
                level, RabitEventIds.Of(entry.Kind), new EntryState(entry), entry.Exception,
                static (state, _) => state.ToString());
        }
    }

    /// <summary>Of a manager, a reader, a message or the reactor itself.</summary>
    public ILogger LoggerOf(string source)
        => _loggers.GetOrAdd(
            source, s => factory.CreateLogger(
                reactor == RabitServiceCollectionExtensions.DefaultName ? "Rabit." + s : $"Rabit.{reactor}.{s}"));

    private static LogLevel LevelOf(RabitLogKind kind) => kind switch
    {
        RabitLogKind.Run => LogLevel.Trace,
        RabitLogKind.Fault => LogLevel.Error,
        RabitLogKind.Hang => LogLevel.Warning,
        _ => LogLevel.Information,
    };
}
