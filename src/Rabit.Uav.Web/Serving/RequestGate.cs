using System;
using System.Collections.Generic;
using System.Net;
using Microsoft.AspNetCore.Http;

namespace Rabit.Uav.Web.Serving;

/// <summary>
/// Which requests are for this page: those by an address, by localhost or by a name of this computer, and of no other
/// page. A name that a stranger's page points at us is refused (DNS rebinding).
/// </summary>
internal sealed class RequestGate
{
    private readonly HashSet<string> _names = new(StringComparer.OrdinalIgnoreCase) { "localhost" };

    public RequestGate(IEnumerable<string> names)
    {
        _names.Add(Environment.MachineName);
        _names.Add(Environment.MachineName + ".local");
        _names.UnionWith(names);
    }

    /// <summary>Whether it came to us.</summary>
    public bool IsHostOurs(HttpRequest request)
    {
        string host = request.Host.Host;
        return host.Length > 0 && (_names.Contains(host) || IPAddress.TryParse(host.Trim('[', ']'), out _));
    }

    /// <summary>Whether no page of another origin sent it. What is no browser names none.</summary>
    public static bool IsOriginOurs(HttpRequest request)
    {
        if (request.Headers.Origin is not [{ } origin])
            return request.Headers.Origin.Count == 0;
        return Uri.TryCreate(origin, UriKind.Absolute, out Uri? from)
            && from.Scheme is "http" or "https"
            && string.Equals(from.Authority, Authority(request), StringComparison.OrdinalIgnoreCase);
    }

    // As Uri writes it: without the port that goes without saying.
    private static string Authority(HttpRequest request)
        => Uri.TryCreate("http://" + request.Host.Value, UriKind.Absolute, out Uri? to) ? to.Authority : string.Empty;
}
