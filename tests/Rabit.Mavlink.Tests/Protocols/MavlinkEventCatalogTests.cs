using System;
using System.Linq;
using System.Text;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Protocols;

public class MavlinkEventCatalogTests
{
    private const string File = """
        {
          "version": 2,
          "components": {
            "1": {
              "namespace": "px4",
              "event_groups": {
                "default": {
                  "events": {
                    "100": { "name": "plain", "message": "Landed" },
                    "101": {
                      "name": "numbers",
                      "message": "{1} {2} {3} {4} {5:.2} {5} {6} {7} {8} {9}",
                      "description": "At {5:.1m_v}, {5:.0m/s}, {1C}, {2m}, {3m^2}",
                      "arguments": [
                        { "type": "int8_t", "name": "a" }, { "type": "int16_t", "name": "b" },
                        { "type": "int32_t", "name": "c" }, { "type": "int64_t", "name": "d" },
                        { "type": "float", "name": "e" }, { "type": "uint8_t", "name": "f" },
                        { "type": "uint16_t", "name": "g" }, { "type": "uint32_t", "name": "h" },
                        { "type": "uint64_t", "name": "i" }
                      ]
                    },
                    "102": {
                      "name": "enums", "message": "{1}, {2}; {3}",
                      "arguments": [
                        { "type": "mode_t", "name": "a" }, { "type": "common::bits_t", "name": "b" },
                        { "type": "px4::mode_t", "name": "c" }
                      ]
                    },
                    "103": {
                      "name": "format",
                      "message": "\\{1} \\<b> \\\\ {0} {2} {1:x} {1 <param>COM_RC_LOSS_T</param> <a>px4.io</a>",
                      "description": "<a href=\"px4.io/x\">here</a><profile name=\"dev\">hidden</profile>\n<profile name=\"!dev\">{1} <param>P</param></profile><profile name=\"normal\">, shown</profile> <new>x</new> <open>\n",
                      "arguments": [ { "type": "uint8_t", "name": "a" } ]
                    }
                  }
                },
                "arming_check": {
                  "events": {
                    "104": {
                      "name": "long", "message": "{6}",
                      "arguments": [
                        { "type": "uint64_t", "name": "a" }, { "type": "uint64_t", "name": "b" },
                        { "type": "uint64_t", "name": "c" }, { "type": "uint64_t", "name": "d" },
                        { "type": "uint64_t", "name": "e" }, { "type": "uint8_t", "name": "f" }
                      ]
                    }
                  }
                }
              },
              "enums": {
                "mode_t": {
                  "type": "int8_t",
                  "entries": {
                    "0": { "name": "hold", "description": "Hold" },
                    "-1": { "name": "none", "description": "no mode" },
                    "3": { "name": "land" }
                  }
                }
              }
            },
            "0": {
              "namespace": "common",
              "enums": {
                "bits_t": {
                  "type": "uint16_t", "is_bitfield": true, "separator": "/",
                  "entries": {
                    "1": { "name": "one", "description": "One" },
                    "32768": { "name": "high", "description": "High" }
                  }
                }
              }
            }
          }
        }
        """;

    private readonly MavlinkEventCatalog _catalog = Parse(File);

    [Fact]
    public void Read_Stream_IsAsItsContent()
    {
        using var file = new System.IO.MemoryStream(Encoding.UTF8.GetBytes(File));
        MavlinkEventCatalog parsed = MavlinkEventCatalog.Parse(Encoding.UTF8.GetBytes(File));
        Assert.Equal(parsed.Count, MavlinkEventCatalog.Read(file).Count);
    }

    // As /dev/zero, which says that its length is 0.
    [Fact]
    public void Read_StreamWithoutEnd_IsRefused()
    {
        using var endless = new EndlessStream();
        FormatException e = Assert.Throws<FormatException>(() => MavlinkEventCatalog.Read(endless));
        Assert.Equal("it has more than 32000000 bytes", e.Message);
    }

    [Fact]
    public void Find_KnownAndUnknown_DefinitionAndNull()
    {
        Assert.Equal(5, _catalog.Count);
        MavlinkEventDefinition plain = _catalog.Find(0x0100_0064)!;
        Assert.Equal(
            (0x0100_0064u, "px4::plain", "default", "Landed", ""),
            (plain.Id, plain.Name, plain.Group, plain.Message, plain.Description));
        Assert.Equal("arming_check", _catalog.Find(0x0100_0068)!.Group);
        Assert.Null(_catalog.Find(100));
        Assert.Equal("Landed", plain.MessageOf(Happened(100)));
        Assert.Equal("", plain.DescriptionOf(Happened(100)));
    }

    [Fact]
    public void MessageOf_NumbersOfEachType_AsTheyWerePacked()
    {
        byte[] arguments =
        [
            0xFD, .. BitConverter.GetBytes((short)-9238), .. BitConverter.GetBytes(832223),
            .. BitConverter.GetBytes(-9277377287318721), .. BitConverter.GetBytes(1234.56f), 200,
            .. BitConverter.GetBytes((ushort)65000), .. BitConverter.GetBytes(4000000000u),
            .. BitConverter.GetBytes(2834873473267162ul),
        ];
        Assert.Equal(
            "-3 -9238 832223 -9277377287318721 1234.56 1234.56 200 65000 4000000000 2834873473267162",
            MessageOf(101, arguments));
        Assert.Equal(
            "At 1234.6 m, 1235 m/s, -3 \u00B0C, -9238 m, 832223 m\u00B2",
            _catalog.Find(0x0100_0065)!.DescriptionOf(Happened(101, arguments)));
    }

    [Fact]
    public void MessageOf_Enums_TextsOfValuesAndBits()
    {
        Assert.Equal("no mode, One/High; land", MessageOf(102, 0xFF, 0x01, 0x80, 3));
        Assert.Equal("Hold, ; (unknown: 7)", MessageOf(102, 0, 0, 0, 7));
        Assert.Equal("(unknown: -2), One/(unknown: 2); Hold", MessageOf(102, 0xFE, 3, 0, 0));
    }

    [Fact]
    public void MessageOf_EscapesTagsAndWhatIsNoFormat_AsDocumented()
    {
        Assert.Equal(@"{1} <b> \ {0} {2} {1:x} {1 COM_RC_LOSS_T px4.io", MessageOf(103, 7));
        Assert.Equal(
            "here (px4.io/x)\n7 P, shown  <open>", _catalog.Find(0x0100_0067)!.DescriptionOf(Happened(103, 7)));
    }

    // Six arguments of 41 bytes: a message has 40.
    [Fact]
    public void MessageOf_ArgumentsBeyondTheMessage_AreQuestionMarks() => Assert.Equal("?", MessageOf(104));

    [Theory]
    [InlineData("", "no JSON")]
    [InlineData("{", "no JSON")]
    [InlineData("[]", "no file of events: it has no \"version\"")]
    [InlineData("""{"version": 3}""", "version 3 of a file of events; versions 1 and 2 are known")]
    [InlineData("""{"version": "1"}""", "version 1 of a file of events")]
    [InlineData("""{"version": 1, "components": []}""", "the file: \"components\" is no object")]
    [InlineData("""{"version": 1, "components": {"1": 5}}""", "component 1: \"namespace\" is no text")]
    [InlineData(
        """{"version": 1, "components": {"256": {"namespace": "a"}}}""",
        "component 256: the number of a component is 0 to 255")]
    [InlineData(
        """{"version": 1, "components": {"1": {"namespace": "a", "enums": {"e": {"type": "float"}}}}}""",
        "component 1, enum e: 'float' is no whole number")]
    [InlineData(
        """{"version": 1, "components": {"1": {"namespace": "a", "enums": {"e": {"type": "int8_t", "entries": {"x": {}}}}}}}""",
        "component 1, enum e: 'x' is no value")]
    [InlineData(
        """{"version": 1, "components": {"1": {"namespace": "a", "event_groups": {"g": {"events": {"16777216": {}}}}}}}""",
        "component 1, event 16777216: the number of an event has 24 bits")]
    [InlineData(
        """{"version": 1, "components": {"1": {"namespace": "a", "event_groups": {"g": {"events": {"1": {"name": "n"}}}}}}}""",
        "component 1, event 1: \"message\" is no text")]
    [InlineData(
        """{"version": 1, "components": {"1": {"namespace": "a", "event_groups": {"g": {"events": {"1": {"name": "n", "message": "m", "arguments": [{"type": "t"}]}}}}}}}""",
        "component 1, event 1: there is no type 't'")]
    [InlineData("""{"version": 1, "components": {"1": {"namespace": "\ud800"}}}""", "no JSON")]
    public void Parse_NoFileOfEvents_SaysWhatAndWhere(string json, string reason)
        => Assert.Contains(reason, Assert.Throws<FormatException>(() => Parse(json)).Message, StringComparison.Ordinal);

    [Fact]
    public void Parse_CompressedFile_SaysSo()
    {
        byte[] file = [0xFD, (byte)'7', (byte)'z', (byte)'X', (byte)'Z', 0, 0, 4];
        Assert.Contains("xz", Assert.Throws<FormatException>(() => MavlinkEventCatalog.Parse(file)).Message);
    }

    [Fact]
    public void Parse_MutatedFile_FormatExceptionOrTexts()
    {
        byte[] whole = Encoding.UTF8.GetBytes(File);
        int parsed = 0;
        for (ulong seed = 1; seed <= 2000; seed++)
        {
            var random = new ProtocolRandom(seed);
            byte[] bytes = whole.ToArray();
            for (int i = 1 + random.Below(3); i > 0; i--)
                bytes[random.Below(bytes.Length)]
                    = (byte)(random.Below(3) == 0 ? random.Below(256) : 32 + random.Below(95));
            try
            {
                MavlinkEventCatalog catalog = MavlinkEventCatalog.Parse(bytes);
                parsed++;
                for (uint id = 0x0100_0064; id < 0x0100_0069; id++)
                {
                    MavlinkEvent happened = Happened(
                        id & 0xFF, Enumerable.Range(0, 40).Select(_ => (byte)random.Next()).ToArray());
                    Assert.NotNull(catalog.Find(id)?.MessageOf(happened) ?? "");
                    Assert.NotNull(catalog.Find(id)?.DescriptionOf(happened) ?? "");
                }
            }
            catch (FormatException e)
            {
                Assert.NotEmpty(e.Message);
            }
        }

        Assert.InRange(parsed, 100, 1999);
    }

    private static MavlinkEventCatalog Parse(string json) => MavlinkEventCatalog.Parse(Encoding.UTF8.GetBytes(json));

    private string MessageOf(uint subId, params byte[] arguments)
        => _catalog.Find(0x0100_0000 | subId)!.MessageOf(Happened(subId, arguments));

    private static MavlinkEvent Happened(uint subId, params byte[] arguments)
    {
        var message = new Event { Id = 0x0100_0000 | subId, Arguments = new ByteArray40(arguments) };
        return new MavlinkEvent(new MavlinkAddress(1, 1), message);
    }

    private sealed class EndlessStream : System.IO.Stream
    {
        public override bool CanRead => true;

        public override bool CanSeek => false;

        public override bool CanWrite => false;

        public override long Length => 0;

        public override long Position { get; set; }

        public override int Read(byte[] buffer, int offset, int count) => count;

        public override void Flush()
        {
        }

        public override long Seek(long offset, System.IO.SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();
    }
}
