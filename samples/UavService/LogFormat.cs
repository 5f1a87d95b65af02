using System;
using Microsoft.Extensions.Logging;
using Microsoft.Extensions.Logging.Console;

namespace UavService;

/// <summary>One line for each entry of the log: with levels for the journal, with times for a terminal.</summary>
internal static class LogFormat
{
    public static void AddLines(this ILoggingBuilder logging)
    {
        // A start that fails would be there with its stack; what is wrong is said in a line each.
        logging.AddFilter("Microsoft.Extensions.Hosting.Internal.Host", LogLevel.None);

        // Each check that fails, each time; HealthLog says when it begins and ends.
        logging.AddFilter("Microsoft.Extensions.Diagnostics.HealthChecks", LogLevel.None);
        if (Environment.GetEnvironmentVariable("JOURNAL_STREAM") is { Length: > 0 })
            logging.AddSystemdConsole();   // the journal has the time
        else
            logging.AddSimpleConsole(o =>
            {
                o.SingleLine = true;
                o.TimestampFormat = "HH:mm:ss ";
            });
    }
}
