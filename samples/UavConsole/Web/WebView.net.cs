using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Net;
using Rabit.Core;
using Rabit.Uav.Communications;
using Rabit.Uav.Web;

namespace UavConsole;

/// <summary>The live page of a run.</summary>
internal sealed class WebView : IDisposable
{
    private readonly LivePage _page;
    private readonly LiveLog _log = new();

    private WebView(LivePage page) => _page = page;

    /// <summary>For people.</summary>
    public string Address => _page.Address!.ToString();

    /// <returns>What is wrong with the address; null where nothing is.</returns>
    public static string? FindFault(WebChoices choices)
    {
        if (ReadAddress(choices.Address) is not { } endPoint)
            return $"--web {choices.Address}: it must be ADDRESS:PORT or PORT, for example 0.0.0.0:8080.";
        return IPAddress.IsLoopback(endPoint.Address) || choices.TokenFile is not null
            ? null
            : $"--web {choices.Address} can be reached from other computers: it needs --web-token FILE.";
    }

    /// <returns>What brings the page the positions of other vehicles.</returns>
    public static IReadOnlyList<MavlinkSubscription> SubscriptionsOf(WebChoices? choices)
        => choices is null ? [] : [LivePage.CreateSubscription()];

    /// <summary>Opens the page, still without a vehicle; null where none is asked for.</summary>
    /// <exception cref="ArgumentException">
    /// The token cannot be read, or the address cannot be opened; the text says why.
    /// </exception>
    public static WebView? Open(WebChoices? choices)
    {
        if (choices is null)
            return null;
        var page = new LivePage(new LivePageOptions
        {
            EndPoint = ReadAddress(choices.Address)!,
            Token = choices.TokenFile is { } file ? LivePageToken.ReadFile(file) : null,
            TileFolder = choices.TileFolder,
            HostNames = choices.HostNames,
        });
        try
        {
            page.StartAsync().GetAwaiter().GetResult();
            return new WebView(page);
        }
        catch (IOException e)
        {
            page.DisposeAsync().AsTask().GetAwaiter().GetResult();
            throw new ArgumentException($"--web {choices.Address}: {e.Message}", nameof(choices), e);
        }
    }

    public void Log(RabitLogEntry entry) => _log.Add(entry);

    /// <summary>Shows the flight. Before the start of its reactor.</summary>
    public void Add(RabitReactor reactor, Flight flight, bool mayCommand)
        => _page.Add(reactor, new LiveVehicleOptions
        {
            Name = flight.MissionName,
            LinkCount = flight.Uav.LinkCount,
            Operator = mayCommand ? flight.Uav.MissionControl : null,
            ImageChips = () => flight.Uav.ImageProcessing.ImageChips,
            Log = _log,
            ShowsOtherVehicles = true,
        });

    public void Dispose() => _page.DisposeAsync().AsTask().GetAwaiter().GetResult();

    private static IPEndPoint? ReadAddress(string? text)
    {
        if (text is null)
            return new LivePageOptions().EndPoint;
        if (ushort.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ushort port))
            return new IPEndPoint(IPAddress.Loopback, port);
        int colon = text.LastIndexOf(':');
        bool hasPort = colon > text.LastIndexOf(']') && (text[0] == '[' || text.IndexOf(':') == colon);
        return hasPort && IPEndPoint.TryParse(text, out IPEndPoint? endPoint) ? endPoint : null;
    }
}
