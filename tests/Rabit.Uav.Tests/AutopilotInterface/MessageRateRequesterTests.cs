using System;
using System.Collections.Generic;
using System.Globalization;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

public class MessageRateRequesterTests
{
    private static readonly RequestedRate[] Rates = [new(30, 25), new(33, 10), new(1, 0.5)];

    // What happens: s start, x stop, a/r/t/p an answer (accepted, refused, temporarily rejected, in progress), w a wait of 1 s, . of 0.5 s.
    // What is sent: message id and try, g and the id for one that was given up, f and the id for one that was refused.
    [Theory]
    [InlineData("", "", 0, 0, 0)]
    [InlineData("ww", "", 0, 0, 0)]
    [InlineData("s", "30/0", 0, 0, 0)]
    [InlineData("saaa", "30/0 33/0 1/0", 3, 0, 0)]
    [InlineData("saaaaww", "30/0 33/0 1/0", 3, 0, 0)]
    [InlineData("s.", "30/0", 0, 0, 0)]
    [InlineData("s..", "30/0 30/1", 0, 0, 0)]
    [InlineData("swwa", "30/0 30/1 30/2 33/0", 1, 0, 0)]
    [InlineData("swww", "30/0 30/1 30/2 g30 33/0", 0, 0, 1)]
    [InlineData("swwwwwwwwwwww", "30/0 30/1 30/2 g30 33/0 33/1 33/2 g33 1/0 1/1 1/2 g1", 0, 0, 3)]
    [InlineData("srarww", "30/0 f30 33/0 1/0 f1", 1, 2, 0)]
    [InlineData("st.a", "30/0 33/0", 1, 0, 0)]
    [InlineData("stwa", "30/0 30/1 33/0", 1, 0, 0)]
    [InlineData("s.p.a", "30/0 33/0", 1, 0, 0)]
    [InlineData("saxaww", "30/0 33/0", 1, 0, 0)]
    [InlineData("saxsa", "30/0 33/0 30/0 33/0", 2, 0, 0)]
    [InlineData("sraasraa", "30/0 f30 33/0 1/0 30/0 f30 33/0 1/0", 4, 2, 0)]
    public void TryNext_Script_AsksOneByOne(string script, string expected, int accepted, int refused, int unanswered)
    {
        var requester = new MessageRateRequester(Rates);
        var sent = new List<string>();
        TimeSpan now = TimeSpan.Zero;
        foreach (char step in script)
        {
            switch (step)
            {
                case 's': requester.Start(); break;
                case 'x': requester.Stop(); break;
                case 'w': now += TimeSpan.FromSeconds(1); break;
                case '.': now += TimeSpan.FromSeconds(0.5); break;
                default: Note(sent, "f", requester.TakeAnswer(ResultOf(step), now)); break;
            }

            // Asked twice: the second time there is never anything to send.
            for (int i = 0; i < 2; i++)
            {
                bool isNew = requester.TryNext(now, out CommandLong command, out int? gaveUp);
                Note(sent, "g", gaveUp);
                if (isNew)
                    sent.Add(string.Format(CultureInfo.InvariantCulture, "{0}/{1}", command.Param1, command.Confirmation));
                Assert.True(i == 0 || !isNew);
            }
        }

        Assert.Equal(expected, string.Join(" ", sent));
        RateRequestCounts counts = requester.Counts;
        Assert.Equal((accepted, refused, unanswered), ((int)counts.Accepted, (int)counts.Refused, (int)counts.Unanswered));
        Assert.Equal(sent.FindAll(s => s.IndexOf('/') > 0).Count, counts.Sent);
    }

    [Fact]
    public void TryNext_Rate_IsSentAsAnIntervalInMicroseconds()
    {
        var requester = new MessageRateRequester(Rates);
        requester.Start();
        Assert.True(requester.TryNext(TimeSpan.Zero, out CommandLong command, out _));

        Assert.Equal(MavCmd.SetMessageInterval, command.Command);
        Assert.Equal(30, command.Param1);
        Assert.Equal(40_000, command.Param2);
        Assert.Equal((0f, 0f, 0f, 0f, 0f), (command.Param3, command.Param4, command.Param5, command.Param6, command.Param7));
    }

    [Fact]
    public void TryNext_NoRates_AsksNothing()
    {
        var requester = new MessageRateRequester([]);
        requester.Start();
        Assert.False(requester.TryNext(TimeSpan.Zero, out _, out _));
        Assert.Null(requester.TakeAnswer(MavResult.Failed, TimeSpan.Zero));
    }

    private static MavResult ResultOf(char step) => step switch
    {
        'a' => MavResult.Accepted,
        'r' => MavResult.Unsupported,
        't' => MavResult.TemporarilyRejected,
        'p' => MavResult.InProgress,
        _ => throw new ArgumentOutOfRangeException(nameof(step), step, "no such step"),
    };

    private static void Note(List<string> sent, string prefix, int? message)
    {
        if (message is { } id)
            sent.Add(prefix + id.ToString(CultureInfo.InvariantCulture));
    }
}
