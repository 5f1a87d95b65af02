using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace UavConsole.Tests;

/// <summary>What keys do, in times that the test gives.</summary>
public sealed class OperatorKeysTests
{
    private readonly Requests _requests = new();
    private readonly OperatorKeys _keys;
    private TimeSpan _now = TimeSpan.FromSeconds(100);
    private int _quits;

    public OperatorKeysTests() => _keys = new OperatorKeys(new MissionKeys(_requests), () => _quits++);

    [Theory]
    [InlineData("r", "return")]
    [InlineData("h", "hold")]
    [InlineData("H", "hold")]
    [InlineData("c", "continue")]
    [InlineData("s", "skip lane")]
    [InlineData("3v", "revisit track 3")]
    [InlineData("12y", "confirm track 12")]
    [InlineData("7n", "reject track 7")]
    [InlineData("ll", "land")]
    public void Press_OneByOne_GivesTheCommand(string keys, string expected)
    {
        foreach (char key in keys)
            Press(key);
        Assert.Equal(expected, Assert.Single(_requests.Given).Name);
        Assert.Equal("console", _requests.Given[0].By);
    }

    [Theory]
    [InlineData("v")]
    [InlineData("y")]
    [InlineData("n")]
    [InlineData("l")]
    [InlineData("x")]
    [InlineData("\r\n \u001b\0")]
    [InlineData("3hv")]
    [InlineData("lhl")]
    public void Press_WithoutWhatItNeeds_GivesNothingOfIt(string keys)
    {
        foreach (char key in keys)
            Press(key);
        Assert.DoesNotContain(_requests.Given, r => r.Command != OperatorCommand.Hold);
    }

    [Fact]
    public void Press_PastedText_HasNoEffect()
    {
        foreach (char key in "return home\nhcrllqq 3v")
            Press(key, seconds: 0.001);
        Wait(5);
        Assert.Empty(_requests.Given);
        Assert.Equal(0, _quits);
        Press('h');
        Assert.Single(_requests.Given);
    }

    // Held down for 3 s: the first repeat comes after 0.5 s, the others every 0.1 s.
    [Theory]
    [InlineData('q')]
    [InlineData('l')]
    public void Press_HeldDown_IsNoSecondPress(char key)
    {
        Press(key, seconds: 0.5);
        for (int i = 0; i < 25; i++)
            Press(key, seconds: 0.1);
        Wait(5);
        Assert.Equal((0, 0), (_quits, _requests.Given.Count));
    }

    [Fact]
    public void Press_HoldHeldDown_GivesOneCommand()
    {
        Press('h', seconds: 0.5);
        for (int i = 0; i < 25; i++)
            Press('h', seconds: 0.1);
        Wait(5);
        Assert.Single(_requests.Given);
    }

    [Theory]
    [InlineData(1.8, 1)]
    [InlineData(2.2, 0)]
    public void Quit_SecondPress_CountsWithinTwoSeconds(double apart, int quits)
    {
        Press('q', apart);
        Assert.Equal(0, _quits);
        Press('q');
        Assert.Equal(quits, _quits);
    }

    [Fact]
    public void Press_AfterTheEnd_HasNoEffect()
    {
        Press('q');
        _keys.Press('h', _now);
        _keys.Close();
        Press('q');
        Press('r');
        Assert.Equal((0, 0, ""), (_quits, _requests.Given.Count, _keys.Line));
    }

    [Fact]
    public void Keys_WithoutAMission_OnlyQuit()
    {
        int quits = 0;
        var keys = new OperatorKeys(commands: null, () => quits++);
        foreach (char key in "rhc3vllqq")
        {
            keys.Press(key, _now);
            _now += TimeSpan.FromSeconds(0.5);
            keys.Update(_now);
        }

        Assert.Equal((1, "qq quit"), (quits, keys.Line));
    }

    [Fact]
    public void Line_ShowsKeysThenWhatIsBegunThenTheAnswer()
    {
        Wait(0.2);
        Assert.StartsWith("r return  h hold", _keys.Line, StringComparison.Ordinal);
        Press('1');
        Press('2');
        Assert.StartsWith("track 12: v revisit", _keys.Line, StringComparison.Ordinal);
        Wait(11);
        Assert.StartsWith("r return", _keys.Line, StringComparison.Ordinal);
        Press('l');
        Assert.Equal("l again within 2 s: land here", _keys.Line);
        Press('h');
        Assert.StartsWith("hold ... | r return", _keys.Line, StringComparison.Ordinal);
    }

    // Mission Control without a mission refuses at once.
    [Fact]
    public void Line_Refused_SaysWhyForAWhile()
    {
        var keys = new OperatorKeys(
            new MissionKeys(new MissionControlManager(new MissionControlOptions())), () => { });
        keys.Press('h', _now);
        _now += TimeSpan.FromSeconds(0.3);
        keys.Update(_now);
        Assert.StartsWith("hold refused: there is no mission | r return", keys.Line, StringComparison.Ordinal);
        keys.Update(_now);
        keys.Update(_now + TimeSpan.FromSeconds(7));
        Assert.StartsWith("r return", keys.Line, StringComparison.Ordinal);
    }

    [Fact]
    public void Bell_TargetAndFailsafe_RingOnceEach()
    {
        int rung = 0;
        var bell = new Bell(() => rung++);
        var status = new MissionStatus { Phase = MissionPhase.Searching };
        int[] counts = [.. new[]
        {
            (0, HealthAdvice.None, null), (1, HealthAdvice.None, null), (1, HealthAdvice.None, null),
            (0, HealthAdvice.None, null), (1, HealthAdvice.Hold, null), (1, HealthAdvice.Hold, null),
            (1, HealthAdvice.None, null), (1, HealthAdvice.None, (string?)"the pilot took over: mode LOITER"),
        }.Select(step =>
        {
            (status.TracksConfirmed, status.TakenOver) = (step.Item1, step.Item3);
            bell.Update(status, step.Item2);
            return rung;
        })];
        Assert.Equal([0, 1, 1, 1, 2, 2, 2, 3], counts);
    }

    private void Press(char key, double seconds = 0.4)
    {
        _keys.Press(key, _now);
        Wait(seconds);
    }

    // The view refreshes several times a second, whenever the keys come.
    private void Wait(double seconds)
    {
        TimeSpan until = _now + TimeSpan.FromSeconds(seconds);
        for (; _now < until; _now += TimeSpan.FromSeconds(Math.Min(0.02, Math.Max(0.001, seconds))))
            _keys.Update(_now);
        _now = until;
    }

    private sealed class Requests : IMissionOperator
    {
        public List<OperatorRequest> Given { get; } = [];

        public OperatorRequest Hold(string by, string reason) => Add(new(OperatorCommand.Hold, by, reason));

        public OperatorRequest ReturnToLaunch(string by, string reason)
            => Add(new(OperatorCommand.Return, by, reason));

        public OperatorRequest ContinueMission(string by, string reason)
            => Add(new(OperatorCommand.Continue, by, reason));

        public OperatorRequest Land(string by, string reason) => Add(new(OperatorCommand.Land, by, reason));

        public OperatorRequest SkipLane(string by, string reason) => Add(new(OperatorCommand.SkipLane, by, reason));

        public OperatorRequest Revisit(int trackId, string by, string reason)
            => Add(new(OperatorCommand.Revisit, by, reason) { TrackId = trackId });

        public OperatorRequest RevisitPlace(GeodeticPosition place, string by, string reason)
            => throw new InvalidOperationException("There is no key for it.");

        public OperatorRequest Confirm(int trackId, string by, string reason)
            => Add(new(OperatorCommand.Confirm, by, reason) { TrackId = trackId });

        public OperatorRequest Reject(int trackId, string by, string reason)
            => Add(new(OperatorCommand.Reject, by, reason) { TrackId = trackId });

        public OperatorRequest ChangeSpeed(double metresPerSecond, string by, string reason)
            => throw new InvalidOperationException("There is no key for it.");

        public OperatorRequest ChangeParameter(MissionParameter parameter, double value, string by, string reason)
            => throw new InvalidOperationException("There is no key for it.");

        public OperatorRequest OfferArea(
            ImmutableArray<GeodeticPosition> area, ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts, string by,
            string reason)
            => throw new InvalidOperationException("There is no key for it.");

        public MissionPlan? Mission => null;

        public void Give(OperatorRequest request) => Add(request);

        private OperatorRequest Add(OperatorRequest request)
        {
            Given.Add(request);
            return request;
        }
    }
}
