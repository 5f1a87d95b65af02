using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Microsoft.Extensions.Logging;

namespace Rabit.Hosting.Tests;

/// <summary>Keeps what is logged. Any thread.</summary>
internal sealed class RecordedLog : ILoggerProvider
{
    private readonly object _gate = new();
    private readonly List<RecordedEntry> _entries = [];
    private readonly AsyncLocal<object?> _scope = new();

    public IReadOnlyList<RecordedEntry> Entries
    {
        get
        {
            lock (_gate)
                return _entries.ToArray();
        }
    }

    public ILogger CreateLogger(string categoryName) => new Logger(this, categoryName);

    public void Dispose()
    {
    }

    public override string ToString() => string.Join("\n", Entries.Select(e => e.ToString()));

    private sealed class Logger(RecordedLog log, string category) : ILogger
    {
        public IDisposable? BeginScope<TState>(TState state)
            where TState : notnull
        {
            log._scope.Value = state;
            return new Scope(log);
        }

        public bool IsEnabled(LogLevel logLevel) => true;

        public void Log<TState>(
            LogLevel logLevel, EventId eventId, TState state, Exception? exception,
            Func<TState, Exception?, string> formatter)
        {
            lock (log._gate)
            {
                log._entries.Add(new RecordedEntry(
                    category, logLevel, eventId, formatter(state, exception), exception, log._scope.Value));
            }
        }
    }

    private sealed class Scope(RecordedLog log) : IDisposable
    {
        public void Dispose() => log._scope.Value = null;
    }
}
