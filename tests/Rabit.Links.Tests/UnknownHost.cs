using System;
using Xunit;

namespace Rabit.Links.Tests;

internal static class UnknownHost
{
    /// <summary>
    /// Opening a link to an unknown host (RFC 6761 keeps <c>.invalid</c> free) says so, with or without a name service.
    /// </summary>
    public static void Check(string scheme)
    {
        string url = $"{scheme}:no-such-host.invalid:14550";

        var fault = Assert.Throws<LinkException>(() => LinkFactory.Open(LinkUrl.Parse(url)));

        Assert.Contains(
            fault.Message,
            new[]
            {
                $"link {url}: the host is unknown",
                $"link {url}: the name of the host cannot be looked up at the moment"
            },
            StringComparer.Ordinal);
    }
}
