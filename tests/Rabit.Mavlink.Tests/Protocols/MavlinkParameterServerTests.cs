using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

public class MavlinkParameterServerTests
{
    private static readonly MavlinkAddress Own = new(1, 191);
    private readonly MavlinkSender _station = new(255, 190);
    private readonly MavlinkParameterList _list;
    private readonly int _speed;
    private readonly int _revisits;
    private MavlinkParameterServer _server;
    private MavlinkParameterChange? _checked;
    private string? _reason;
    private TimeSpan _now = TimeSpan.FromSeconds(10);

    public MavlinkParameterServerTests()
    {
        _list = new MavlinkParameterList((in MavlinkParameterChange change) =>
        {
            _checked = change;
            return _reason;
        });
        _speed = _list.Add("RBT_SPEED", MavParamType.Real32, 6, 2, 12);
        _revisits = _list.Add("RBT_REVISITS_MAX", MavParamType.Int32, -1);
        _server = New(new MavlinkParameterServerOptions());
    }

    [Fact]
    public void Handle_ReadByNameAndIndex_AnsweredByTheValue()
    {
        Read("RBT_SPEED", -1);
        Read("", _revisits);
        ParamValue[] values = Values();
        Assert.Equal(["RBT_SPEED", "RBT_REVISITS_MAX"], values.Select(value => value.ParamId.ToString()));
        Assert.Equal([0, 1], values.Select(value => (int)value.ParamIndex));
        Assert.All(values, value => Assert.Equal(2, value.ParamCount));
        Assert.Equal(6f, values[0].Value);
        Assert.Equal(uint.MaxValue, MavlinkParameter.FromFloat(values[1].Value));   // -1, byte by byte
        Assert.Equal(TimeSpan.MaxValue, _server.NextDue);
    }

    [Fact]
    public void Handle_ReadOfUnknown_ErrorThatNamesIt()
    {
        Read("NO_SUCH", -1);
        Read("", 2);
        List<MavlinkFrame> frames = Take();
        Assert.Equal(2, frames.Count);
        Assert.True(frames[0].TryDecode(out ParamError byName));
        Assert.Equal(("NO_SUCH", -1, 255), (byName.ParamId.ToString(), byName.ParamIndex, byName.TargetSystem));
        Assert.True(frames[1].TryDecode(out ParamError byIndex));
        Assert.Equal((2, MavParamError.DoesNotExist), (byIndex.ParamIndex, byIndex.Error));
        Assert.Equal(2, _server.Unknowns);

        _server = New(new MavlinkParameterServerOptions { SendsErrors = false });
        Read("NO_SUCH", -1);
        Assert.Empty(Take());
    }

    [Fact]
    public void Handle_Set_CheckedSetAndAnswered()
    {
        Set("RBT_SPEED", MavParamType.Real32, 8.5);
        Assert.Equal(8.5f, Assert.Single(Values()).Value);
        Assert.Equal(8.5, _list[_speed].Value);
        MavlinkParameterChange change = Assert.NotNull(_checked);
        Assert.Equal((6, 8.5, new MavlinkAddress(255, 190), false),
            (change.Parameter.Value, change.Value, change.Source, change.IsSigned));
    }

    [Theory]
    [InlineData("RBT_SPEED", 13, MavParamType.Real32, MavParamError.ValueOutOfRange, "RBT_SPEED: 13 is not 2 to 12")]
    [InlineData("RBT_SPEED", double.NaN, MavParamType.Real32, MavParamError.ValueOutOfRange, "NaN does not fit")]
    [InlineData("RBT_SPEED", double.PositiveInfinity, MavParamType.Real32, MavParamError.ValueOutOfRange, "not fit")]
    [InlineData("RBT_SPEED", 7, MavParamType.Int32, MavParamError.TypeMismatch, "Int32 is not its type, Real32")]
    public void Handle_SetThatIsRefused_OldValueErrorAndReason(
        string name, double value, MavParamType type, MavParamError error, string reason)
    {
        Set(name, type, value);
        List<MavlinkFrame> frames = Take();
        Assert.True(frames[0].TryDecode(out ParamValue old));
        Assert.Equal(6f, old.Value);
        Assert.True(frames[1].TryDecode(out ParamError sent));
        Assert.Equal((error, name), (sent.Error, sent.ParamId.ToString()));
        Assert.True(frames[2].TryDecode(out Statustext text));
        Assert.Contains(reason, TextOf(frames), StringComparison.Ordinal);
        Assert.Equal(MavSeverity.Warning, text.Severity);
        Assert.Equal((6, 1), (_list[_speed].Value, _server.Refusals));
    }

    [Fact]
    public void Handle_SetRefusedByTheCaller_LongReasonInChunks()
    {
        _reason = new string('x', 50) + new string('y', 50) + "end \u20AC";
        Set("RBT_SPEED", MavParamType.Real32, 7);
        Statustext[] parts = Take().Skip(2).Select(frame => Decode<Statustext>(frame)).ToArray();
        Assert.Equal([0, 1, 2], parts.Select(part => (int)part.ChunkSeq));
        Assert.All(parts, part => Assert.Equal(1, part.Id));
        Assert.Equal(_reason, string.Concat(parts.Select(part => part.Text.ToString())));
        Assert.Equal(6, _list[_speed].Value);

        Set("RBT_SPEED", MavParamType.Real32, 7);
        Assert.All(Take().Skip(2), frame => Assert.Equal(2, Decode<Statustext>(frame).Id));
    }

    [Theory]
    [InlineData(MavlinkParameterEncoding.Bytewise, 40_000_001, 40_000_001)]
    [InlineData(MavlinkParameterEncoding.CCast, 40_000_000, 40_000_000)]
    public void Set_WholeNumbers_TravelInTheirEncoding(MavlinkParameterEncoding encoding, double value, double expected)
    {
        _server = new MavlinkParameterServer(new MavlinkSender(1, 191), _list, encoding);
        uint bits = encoding == MavlinkParameterEncoding.Bytewise
            ? (uint)value
            : MavlinkParameter.FromFloat((float)value);
        _server.Handle(_station.Create(new ParamSet
        {
            TargetSystem = 1,
            TargetComponent = 191,
            ParamId = new Text16("RBT_REVISITS_MAX"),
            ParamType = encoding == MavlinkParameterEncoding.CCast ? MavParamType.Real32 : MavParamType.Int32,
            ParamValue = MavlinkParameter.ToFloat(bits),
        }), _now);
        Assert.Equal(expected, MavlinkParameter.From(Assert.Single(Values())).ToDouble(encoding));
        Assert.Equal(expected, _list[_revisits].Value);
    }

    [Fact]
    public void List_IsPacedAndDoesNotStartOverForAnother()
    {
        for (int i = 2; i < 10; i++)
            _list.Add($"P{i}", MavParamType.Real32, i);
        List();
        var indices = new List<int>();
        TimeSpan start = _now;
        while (_server.IsListing)
        {
            _now = _server.NextDue > _now ? _server.NextDue : _now;
            indices.Add(Assert.Single(Values()).ParamIndex);
            if (indices.Count == 4)
                List();
        }

        Assert.Equal([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 1, 2, 3], indices);
        Assert.Equal(13 * 0.02, (_now - start).TotalSeconds, 6);
    }

    [Fact]
    public void List_CallerThatComesSeldom_IsNotFlooded()
    {
        for (int i = 2; i < 100; i++)
            _list.Add($"P{i}", MavParamType.Real32, i);
        List();
        _now += TimeSpan.FromSeconds(5);
        Assert.InRange(Values().Length, 1, 7);
    }

    [Theory]
    [InlineData(1, 191, true, true)]
    [InlineData(1, 0, true, false)]
    [InlineData(0, 0, false, false)]
    [InlineData(1, 1, false, false)]
    [InlineData(2, 191, false, false)]
    public void Handle_Address_ListsForAllReadsForUs(byte system, byte component, bool lists, bool reads)
    {
        _server.Handle(
            _station.Create(new ParamRequestList { TargetSystem = system, TargetComponent = component }), _now);
        Assert.Equal(lists, _server.IsListing);
        _server = New(new MavlinkParameterServerOptions { ListsForAll = false });
        var read = new ParamRequestRead { TargetSystem = system, TargetComponent = component };
        _server.Handle(_station.Create(read), _now);
        Assert.Equal(reads, Take().Count > 0);
    }

    [Fact]
    public void Report_ChangedFromThisSide_IsSent()
    {
        _list.Set(_speed, 9);
        _server.Report(_speed);
        Assert.Equal(9f, Assert.Single(Values()).Value);
        Assert.Throws<ArgumentOutOfRangeException>(() => _server.Report(2));
    }

    [Fact]
    public void Handle_TooManyRequests_AreDroppedAndCounted()
    {
        _server = New(new MavlinkParameterServerOptions { Capacity = 3 });
        for (int i = 0; i < 5; i++)
            Read("RBT_SPEED", -1);
        Assert.Equal(2, _server.Dropped);
        Assert.Equal(3, Values().Length);
    }

    [Fact]
    public void List_BadInput_NamesTheThing()
    {
        Assert.Contains("RBT_SPEED", Assert.Throws<ArgumentException>(
            () => _list.Add("RBT_SPEED", MavParamType.Real32, 1)).Message);
        Assert.Contains("64 bits", Assert.Throws<ArgumentException>(
            () => _list.Add("A", MavParamType.Real64, 1)).Message);
        Assert.Contains("from 0 to 10", Assert.Throws<ArgumentException>(
            () => _list.Add("A", MavParamType.Uint8, 11, 0, 10)).Message);
        Assert.Throws<ArgumentException>(() => _list.Add("A", MavParamType.Uint8, 256));
        Assert.Throws<ArgumentException>(() => _list.Add("", MavParamType.Uint8, 0));
        Assert.Throws<ArgumentException>(() => _list.Add("SEVENTEEN_LETTERS", MavParamType.Uint8, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => _list.Set(_revisits, 3e9));
        Assert.Throws<ArgumentNullException>(
            () => new MavlinkParameterServer(null!, _list, MavlinkParameterEncoding.CCast));
        Assert.Throws<ArgumentNullException>(
            () => new MavlinkParameterServer(_station, null!, MavlinkParameterEncoding.CCast));
        Assert.Throws<ArgumentOutOfRangeException>(() => New(new MavlinkParameterServerOptions { Capacity = 0 }));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => New(new MavlinkParameterServerOptions { ListInterval = TimeSpan.Zero }));
    }

    private static T Decode<T>(in MavlinkFrame frame)
        where T : struct, IMavlinkMessage
    {
        Assert.True(frame.TryDecode(out T message));
        return message;
    }

    private static string TextOf(List<MavlinkFrame> frames) => string.Concat(frames
        .Where(frame => frame.MessageId == Statustext.MavlinkId)
        .Select(frame => Decode<Statustext>(frame).Text.ToString()));

    private MavlinkParameterServer New(MavlinkParameterServerOptions options)
        => new(new MavlinkSender(1, 191), _list, MavlinkParameterEncoding.Bytewise, options);

    private void List() => _server.Handle(
        _station.Create(new ParamRequestList { TargetSystem = 1, TargetComponent = 191 }), _now);

    private void Read(string name, int index) => _server.Handle(_station.Create(new ParamRequestRead
    {
        TargetSystem = Own.SystemId,
        TargetComponent = Own.ComponentId,
        ParamId = new Text16(name),
        ParamIndex = (short)index,
    }), _now);

    private void Set(string name, MavParamType type, double value) => _server.Handle(_station.Create(new ParamSet
    {
        TargetSystem = Own.SystemId,
        TargetComponent = Own.ComponentId,
        ParamId = new Text16(name),
        ParamType = type,
        ParamValue = (float)value,
    }), _now);

    private List<MavlinkFrame> Take()
    {
        var frames = new List<MavlinkFrame>();
        while (_server.TryTakeFrame(_now, out MavlinkFrame frame))
            frames.Add(frame);
        return frames;
    }

    private ParamValue[] Values() => Take().Select(frame => Decode<ParamValue>(frame)).ToArray();
}
