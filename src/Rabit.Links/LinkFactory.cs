using System;

namespace Rabit.Links;

/// <summary>Opens the link that a <see cref="LinkUrl"/> names.</summary>
/// <example>
/// <code>
/// using IByteLink link = LinkFactory.Open(LinkUrl.Parse("serial:/dev/ttyAMA0:921600"));
/// LinkRead read = link.Read(buffer);   // waits for bytes, the end, or Unblock
/// </code>
/// </example>
public static class LinkFactory
{
    /// <summary>
    /// Opens a live link, once: when it ends it is over. <see cref="ReopeningLink"/> opens it again.
    /// May wait: for a host to take a connection, and for the system to look up its name.
    /// </summary>
    /// <param name="url">Any kind but <see cref="LinkKind.RecordedFile"/>.</param>
    /// <param name="options">How long to wait; the defaults if left out.</param>
    /// <exception cref="LinkException">It cannot be opened; the message names the link and the reason.</exception>
    /// <exception cref="PlatformNotSupportedException">A serial line on another system than Linux.</exception>
    /// <exception cref="ArgumentException">A recorded file: it is played, not opened as a live link.</exception>
    public static IByteLink Open(LinkUrl url, LinkOptions? options = null)
    {
        if (url is null) throw new ArgumentNullException(nameof(url));
        return Open(url, options, new LinkStop());
    }

    internal static IByteLink Open(LinkUrl url, LinkOptions? options, LinkStop stop)
    {
        options = (options ?? LinkOptions.Default).With(url.Settings);
        return url.Kind switch
        {
            LinkKind.UdpListen => UdpListenLink.Open(url.Host!, url.Port, options, stop),
            LinkKind.UdpSend => UdpSendLink.Open(url.Host!, url.Port, options, stop),
            LinkKind.TcpClient => TcpClientLink.Open(url.Host!, url.Port, options, stop),
            LinkKind.TcpServer => TcpServerLink.Open(url.Host!, url.Port, options, stop),
            LinkKind.UdpBroadcast => UdpBroadcastLink.Open(url.Host!, url.Port, options),
            LinkKind.Serial => SerialLink.Open(url.Path!, url.BaudRate, options),
            _ =>
                throw new ArgumentException(
                    $"link {url}: a recorded file is played, not opened as a live link", nameof(url)),
        };
    }
}
