using System;
using Microsoft.Extensions.Logging;

namespace Rabit.Hosting.Tests;

internal sealed record RecordedEntry(
    string Category, LogLevel Level, EventId Id, string Text, Exception? Exception, object? Scope);
