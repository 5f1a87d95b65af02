using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Core;
using Rabit.Diagnostics.Observing;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Diagnostics.Serving;

/// <summary>Answers the requests of one client. The session's thread only.</summary>
internal sealed class RequestHandler(ServedProgram program, ClientLimits limits, ClientLines lines)
{
    private SampleStream? _status;
    private SampleStream? _echo;

    public bool IsStreaming => _status is not null || _echo is not null;

    /// <summary>Until the next sample is due.</summary>
    public TimeSpan Remaining
    {
        get
        {
            TimeSpan status = _status?.Remaining ?? TimeSpan.MaxValue;
            TimeSpan echo = _echo?.Remaining ?? TimeSpan.MaxValue;
            return status < echo ? status : echo;
        }
    }

    /// <summary>Sends what is due.</summary>
    /// <returns>How many samples were left out.</returns>
    public long SendDue() => (_status?.SendDue() ?? 0) + (_echo?.SendDue() ?? 0);

    /// <exception cref="RefusedRequestException">It asks for something that is not there.</exception>
    public void Answer(RequestLine request)
    {
        switch (request.Request)
        {
            case RequestLine.Status:
                AnswerStatus(request);
                break;
            case RequestLine.Graph:
                AnswerGraph(request);
                break;
            case RequestLine.Echo:
                AnswerEcho(request);
                break;
            case null:
                throw new RefusedRequestException("A request has a member \"request\".");
            default:
                throw new RefusedRequestException(
                    $"There is no request '{Shorten(request.Request)}'; there are: {RequestLine.Status}, "
                        + $"{RequestLine.Graph}, {RequestLine.Echo}.");
        }
    }

    private void AnswerStatus(RequestLine request)
    {
        program.Find(request.Reactor);   // whether there is one of that name
        var sampler = new StatusSampler(() => program.Find(request.Reactor), program.Clock);
        if (request.EveryMilliseconds is not { } every)
        {
            lines.Send(sampler.Read(), ProtocolJson.Default.SampleLine);
            return;
        }

        _status = new SampleStream(program.Clock, Interval(every, limits.MinStatusInterval), stream => lines.Send(
            sampler.Read() with { Sequence = ++stream.Sent, SkippedSamples = stream.Skipped },
            ProtocolJson.Default.SampleLine));
    }

    private void AnswerGraph(RequestLine request)
    {
        string format = request.Format ?? "text";
        if (!Enum.TryParse(format, ignoreCase: true, out WiringFormat wiring) || !Enum.IsDefined(wiring)
            || char.IsAsciiDigit(format[0]))
            throw new RefusedRequestException(
                $"There is no format '{Shorten(format)}'; there are: text, mermaid, dot.");
        lines.Send(
            new GraphLine
            {
                Format = format.ToLowerInvariant(),
                Reactors = program.Find(request.Reactor)
                    .Select(r => new ReactorGraph { Name = r.Name, Text = r.Workspace.DescribeWiring(wiring) })
                    .ToArray(),
            },
            ProtocolJson.Default.GraphLine);
    }

    private void AnswerEcho(RequestLine request)
    {
        if (request.Message is not { } message)
            throw new RefusedRequestException("An echo has a member \"message\": the name of the message.");
        var echo = new MessageEcho(FindMessage(message, request.Reactor));
        if (request.EveryMilliseconds is not { } every)
        {
            lines.Send(echo.Read());
            return;
        }

        _echo = new SampleStream(program.Clock, Interval(every, limits.MinEchoInterval), stream =>
        {
            if (!echo.HasNews && stream.Sent > 0)
                return;
            lines.Send(echo.Read());
            stream.Sent++;
        });
    }

    private EchoedMessage FindMessage(string name, string? reactorName)
    {
        EchoedMessage[] all = program.Find(reactorName)
            .SelectMany(r => r.Workspace.ObserveMessages().Select(m => new EchoedMessage(r, m))).ToArray();
        EchoedMessage[] found = Array.FindAll(
            all, m => string.Equals(m.Observer.Name, name, StringComparison.Ordinal));
        return found.Length switch
        {
            1 => found[0],
            0 when all.Length == 0 => throw new RefusedRequestException("No reactor has started yet."),
            0 => throw new RefusedRequestException(
                $"There is no message '{Shorten(name)}'; there are: "
                    + ListOf(all.Select(m => m.Observer.Name)) + "."),
            _ => throw new RefusedRequestException(
                $"Several reactors have a message '{name}'; name one: "
                    + ListOf(found.Select(m => m.Reactor.Name)) + "."),
        };
    }

    // Statuses of managers are under names that follow from the others.
    private static string ListOf(IEnumerable<string> names)
        => string.Join(
            ", ", names.Where(n => !n.EndsWith("/status", StringComparison.Ordinal)).Distinct(StringComparer.Ordinal)
                .Take(200));

    private static string Shorten(string name) => name.Length <= 100 ? name : name[..100] + "...";

    private TimeSpan Interval(int milliseconds, TimeSpan min)
    {
        TimeSpan interval = TimeSpan.FromMilliseconds(milliseconds);
        return interval >= min && interval <= limits.MaxInterval
            ? interval
            : throw new RefusedRequestException(string.Create(
                CultureInfo.InvariantCulture,
                $"everyMilliseconds is {milliseconds}; it must be {min.TotalMilliseconds} to "
                    + $"{limits.MaxInterval.TotalMilliseconds}."));
    }
}
