using System;
using Xunit;

namespace Rabit.Links.Tests;

public sealed class LinkUrlTests
{
    private const string AllForms =
        "udpin:ADDRESS:PORT, udpout:HOST:PORT, udpbcast:ADDRESS:PORT, tcp:HOST:PORT, tcpin:ADDRESS:PORT, "
            + "serial:DEVICE:BAUD or tlog:FILE[?speed=10|max]";

    private const string UdpListenForm = "udpin:ADDRESS:PORT, for example udpin:0.0.0.0:14550";
    private const string UdpSendForm = "udpout:HOST:PORT, for example udpout:192.168.1.10:14550";
    private const string TcpForm = "tcp:HOST:PORT, for example tcp:127.0.0.1:5760";
    private const string SerialForm = "serial:DEVICE:BAUD, for example serial:/dev/ttyAMA0:921600";
    private const string FileForm = "tlog:FILE[?speed=10|max], for example tlog:flight.tlog?speed=10";

    [Theory]
    [InlineData("udpin:0.0.0.0:14550", LinkKind.UdpListen, "0.0.0.0", 14550)]
    [InlineData("udpout:ground.example:14551", LinkKind.UdpSend, "ground.example", 14551)]
    [InlineData("udpout:[fe80::1%eth0]:1", LinkKind.UdpSend, "fe80::1%eth0", 1)]
    [InlineData("tcp:127.0.0.1:65535", LinkKind.TcpClient, "127.0.0.1", 65535)]
    [InlineData("tcp:[::1]:5760", LinkKind.TcpClient, "::1", 5760)]
    [InlineData("TCP:localhost:5760", LinkKind.TcpClient, "localhost", 5760)]
    [InlineData("  udpin:[::]:14550 ", LinkKind.UdpListen, "::", 14550)]
    public void Parse_Socket_GivesHostAndPort(string text, LinkKind kind, string host, int port)
    {
        LinkUrl url = LinkUrl.Parse(text);

        Assert.Equal((kind, host, port), (url.Kind, url.Host, url.Port));
        Assert.Null(url.Path);
        Assert.Equal(0, url.BaudRate);
        Assert.Equal(1, url.Speed);
    }

    [Theory]
    [InlineData("serial:/dev/ttyAMA0:921600", "/dev/ttyAMA0", 921600)]
    [InlineData("serial:/dev/serial/by-path/pci-0000:00:14.0-usb-0:2:1.0-port0:57600",
        "/dev/serial/by-path/pci-0000:00:14.0-usb-0:2:1.0-port0", 57600)]
    [InlineData("serial:COM3:250000", "COM3", 250000)]
    public void Parse_Serial_GivesDeviceAndBaudRate(string text, string device, int baudRate)
    {
        LinkUrl url = LinkUrl.Parse(text);

        Assert.Equal((LinkKind.Serial, device, baudRate), (url.Kind, url.Path, url.BaudRate));
        Assert.Null(url.Host);
        Assert.Equal(0, url.Port);
    }

    [Theory]
    [InlineData("tlog:flight.tlog", "flight.tlog", 1)]
    [InlineData("tlog:flight.tlog?speed=10", "flight.tlog", 10)]
    [InlineData("tlog:flight.tlog?speed=0.25", "flight.tlog", 0.25)]
    [InlineData("tlog:flight.tlog?speed=max", "flight.tlog", double.PositiveInfinity)]
    [InlineData("tlog:flight.tlog?SPEED=MAX", "flight.tlog", double.PositiveInfinity)]
    [InlineData(@"tlog:C:\logs\flight.tlog?speed=2", @"C:\logs\flight.tlog", 2)]
    [InlineData("tlog:/logs/12:30:05 what?.tlog", "/logs/12:30:05 what?.tlog", 1)]
    [InlineData("tlog:/logs/what?.tlog?speed=3", "/logs/what?.tlog", 3)]
    [InlineData("tlog:a=b.tlog", "a=b.tlog", 1)]
    public void Parse_RecordedFile_GivesPathAndSpeed(string text, string path, double speed)
    {
        LinkUrl url = LinkUrl.Parse(text);

        Assert.Equal((LinkKind.RecordedFile, path, speed), (url.Kind, url.Path, url.Speed));
    }

    [Theory]
    [InlineData("udpin:0.0.0.0:14550")]
    [InlineData("udpout:[::1]:14550")]
    [InlineData("tcp:localhost:5760")]
    [InlineData("serial:/dev/ttyAMA0:921600")]
    [InlineData("tlog:flight.tlog")]
    [InlineData("tlog:what?.tlog?speed=0.1")]
    [InlineData("tlog:flight.tlog?speed=max")]
    public void ToString_OfAParsedOne_IsTheSameText(string text) => Assert.Equal(text, LinkUrl.Parse(text).ToString());

    [Theory]
    [InlineData(null, "the name of a link is empty; write " + AllForms)]
    [InlineData("  ", "the name of a link is empty; write " + AllForms)]
    [InlineData("/dev/ttyAMA0", "link '/dev/ttyAMA0' has no scheme; write " + AllForms)]
    [InlineData("udp:0.0.0.0:14550", "link 'udp:0.0.0.0:14550': the scheme 'udp' is unknown; write " + AllForms)]
    [InlineData(@"C:\flight.tlog", @"link 'C:\flight.tlog': the scheme 'C' is unknown; write " + AllForms)]
    [InlineData(":1", "link ':1': the scheme '' is unknown; write " + AllForms)]
    [InlineData("udpin:", "link 'udpin:': the port is missing; write " + UdpListenForm)]
    [InlineData("udpin:0.0.0.0", "link 'udpin:0.0.0.0': the port is missing; write " + UdpListenForm)]
    [InlineData("udpin:0.0.0.0:", "link 'udpin:0.0.0.0:': the port is missing; write " + UdpListenForm)]
    [InlineData("udpin::14550", "link 'udpin::14550': the host is missing; write " + UdpListenForm)]
    [InlineData("udpin:0.0.0.0:0",
        "link 'udpin:0.0.0.0:0': the port '0' is not a number from 1 to 65535; write " + UdpListenForm)]
    [InlineData("udpout:gcs:65536",
        "link 'udpout:gcs:65536': the port '65536' is not a number from 1 to 65535; write " + UdpSendForm)]
    [InlineData("udpout:gcs:-1",
        "link 'udpout:gcs:-1': the port '-1' is not a number from 1 to 65535; write " + UdpSendForm)]
    [InlineData("udpout:gcs:14550/x",
        "link 'udpout:gcs:14550/x': the port '14550/x' is not a number from 1 to 65535; write " + UdpSendForm)]
    [InlineData("udpout:a b:14550", "link 'udpout:a b:14550': the host 'a b' holds a ' '; write " + UdpSendForm)]
    [InlineData("tcp://host:5760", "link 'tcp://host:5760': there are no slashes after the scheme; write " + TcpForm)]
    [InlineData("tcp:::1:5760",
        "link 'tcp:::1:5760': the host '::1' holds a colon (an IPv6 address is written in brackets, [::1]); write "
            + TcpForm)]
    [InlineData("tcp:[::1:5760",
        "link 'tcp:[::1:5760': the bracket around the address is not closed; write " + TcpForm)]
    [InlineData("tcp:[::1]", "link 'tcp:[::1]': the port is missing; write " + TcpForm)]
    [InlineData("tcp:[::1]5760",
        "link 'tcp:[::1]5760': after the closing bracket a colon and the port must follow; write " + TcpForm)]
    [InlineData("tcp:[host]:5760",
        "link 'tcp:[host]:5760': 'host' in brackets is not an IPv6 address; write " + TcpForm)]
    [InlineData("tcp:[]:5760", "link 'tcp:[]:5760': the host is missing; write " + TcpForm)]
    [InlineData("serial:", "link 'serial:': the device is missing; write " + SerialForm)]
    [InlineData("serial::57600", "link 'serial::57600': the device is missing; write " + SerialForm)]
    [InlineData("serial:/dev/ttyAMA0", "link 'serial:/dev/ttyAMA0': the baud rate is missing; write " + SerialForm)]
    [InlineData("serial:/dev/ttyAMA0:", "link 'serial:/dev/ttyAMA0:': the baud rate is missing; write " + SerialForm)]
    [InlineData("serial:/dev/ttyAMA0:fast",
        "link 'serial:/dev/ttyAMA0:fast': the baud rate 'fast' is not a positive whole number; write " + SerialForm)]
    [InlineData("serial:/dev/ttyAMA0:0",
        "link 'serial:/dev/ttyAMA0:0': the baud rate '0' is not a positive whole number; write " + SerialForm)]
    [InlineData("serial:/dev/tty\0:9600",
        @"link 'serial:/dev/tty\0:9600': the device holds a zero character; write " + SerialForm)]
    [InlineData("tlog:", "link 'tlog:': the file is missing; write " + FileForm)]
    [InlineData("tlog:?speed=2", "link 'tlog:?speed=2': the file is missing; write " + FileForm)]
    [InlineData("tlog:f?speed=1000001",
        "link 'tlog:f?speed=1000001': the speed '1000001' is above 1000000; that is max; write " + FileForm)]
    [InlineData("tlog:f?speed=0",
        "link 'tlog:f?speed=0': the speed '0' is not a positive number or max; write " + FileForm)]
    [InlineData("tlog:f?speed=-1",
        "link 'tlog:f?speed=-1': the speed '-1' is not a positive number or max; write " + FileForm)]
    [InlineData("tlog:f?speed=fast",
        "link 'tlog:f?speed=fast': the speed 'fast' is not a positive number or max; write " + FileForm)]
    [InlineData("tlog:f?speed=NaN",
        "link 'tlog:f?speed=NaN': the speed 'NaN' is not a positive number or max; write " + FileForm)]
    [InlineData("tlog:f?speed=",
        "link 'tlog:f?speed=': the speed '' is not a positive number or max; write " + FileForm)]
    [InlineData("tlog:f?speed", "link 'tlog:f?speed': the speed '' is not a positive number or max; write " + FileForm)]
    [InlineData("tlog:f?sped=10", "link 'tlog:f?sped=10': the option 'sped' is unknown; write " + FileForm)]
    public void TryParse_WrongForm_SaysWhatIsWrongAndShowsTheRightForm(string? text, string expected)
    {
        Assert.False(LinkUrl.TryParse(text, out LinkUrl? url, out string? error));

        Assert.Null(url);
        Assert.Equal(expected, error);
        Assert.Equal(expected, Assert.Throws<FormatException>(() => LinkUrl.Parse(text)).Message);
    }
}
