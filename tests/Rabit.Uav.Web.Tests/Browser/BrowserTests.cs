using System;
using System.Globalization;
using System.IO;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Web.Tests.Browser;

/// <summary>
/// The page in a browser, while a simulated search is flown. With RABIT_UPDATE_DOCS=1 the pictures of the documents are
/// made again. In real time, and a browser beside them: longer tests, which CI executes in a stage of their own.
/// </summary>
[Trait("Category", "Long")]
public sealed class BrowserTests(Chromium chromium, ITestOutputHelper output) : IClassFixture<Chromium>
{
    private static readonly TimeSpan CompleteWithin = TimeSpan.FromSeconds(2);

    // The best of so many counts, so that a busy machine does not matter.
    private const int Attempts = 3;

    private static bool MakesPictures => Environment.GetEnvironmentVariable("RABIT_UPDATE_DOCS") == "1";

    [BrowserFact]
    public async Task Page_SimulatedFlight_LoadsWithoutErrorAndFollowsIt()
    {
        await using PageFlight flight = await PageFlight.StartAsync();
        BrowserTab tab = await OpenAsync(flight, 1280, 860);
        await tab.WaitForTextAsync("phase", "searching");

        double height = await NumberOfAsync(tab, "height");
        Assert.InRange(height, flight.Vehicle.HeightAboveHomeMetres - 3, flight.Vehicle.HeightAboveHomeMetres + 3);
        double coverage = flight.MissionStatus.Coverage * 100;
        await tab.WaitAsync(FormattableString.Invariant(
            $"parseFloat(document.getElementById('coverage').textContent) >= {coverage - 0.1}"));
        Assert.True(await NumberOfAsync(tab, "coverage") <= (flight.MissionStatus.Coverage * 100) + 0.1);
        Assert.Equal("small meadow", await tab.TextAsync("name"));
        Assert.Equal(flight.Vehicle.Mode, (await tab.TextAsync("mode")).Split(',')[0]);

        await tab.WaitAsync("document.querySelectorAll('#tracks img').length >= 1");
        await tab.WaitAsync("[...document.querySelectorAll('#tracks img')].every(i => i.naturalWidth > 0)");
        await tab.WaitAsync("document.querySelectorAll('#managers tr').length >= 7");
        await tab.WaitAsync("document.querySelectorAll('#log li').length >= 10");
        await tab.WaitForTextAsync("links", "receiving");
        await tab.WaitAsync("parseFloat(document.querySelector('#managers td.n').textContent) > 0");
        await tab.WaitAsync("parseFloat(document.getElementById('coverage').textContent) > 75");
        await SaveAsync(tab, "live-page.png");
        await tab.SetColoursAsync(isDark: true);
        await tab.WaitAsync("getComputedStyle(document.body).backgroundColor === 'rgb(15, 21, 29)'");

        await tab.WaitForTextAsync("phase", "done");
        Assert.Equal(MissionPhase.Done, flight.MissionStatus.Phase);
        Assert.Empty(tab.Errors);
        Assert.Equal(0, flight.Page.Counters.Faults);
        Assert.InRange(flight.Page.Counters.MaxMessageBytes, 1, 3000);
    }

    [BrowserFact]
    public async Task Return_PressedTwice_BringsTheAircraftHome()
    {
        await using PageFlight flight = await PageFlight.StartAsync();
        BrowserTab tab = await OpenAsync(flight, 1280, 860);
        await GiveTokenAsync(tab, PageFlight.Token);
        await tab.WaitForTextAsync("phase", "searching");
        await tab.ClickAsync("[data-command=return]");
        await tab.WaitAsync("document.querySelector('[data-command=return]').textContent === 'Return?'");
        Assert.Equal(0, flight.Page.Counters.Commands);

        // On a busy machine it has found a target meanwhile.
        Assert.Contains(flight.MissionStatus.Phase, new[] { MissionPhase.Searching, MissionPhase.Revisiting });

        await tab.ClickAsync("[data-command=return]");
        await tab.WaitForTextAsync("phase", "returning");
        await tab.WaitForTextAsync("given", "accepted");
        await tab.WaitForTextAsync("phase", "done");
        Assert.Equal(1, flight.Page.Counters.Commands);
        Assert.NotNull(flight.World.Truth.Landing);
        Assert.InRange(await NumberOfAsync(tab, "home"), 0, 3);
        Assert.Empty(tab.Errors);
    }

    [BrowserFact]
    public async Task Command_WithAWrongToken_DoesNothing()
    {
        await using PageFlight flight = await PageFlight.StartAsync();
        BrowserTab tab = await OpenAsync(flight, 1280, 860);
        await GiveTokenAsync(tab, "not-the-token-of-this-flight");
        await tab.WaitForTextAsync("phase", "searching");
        await tab.ClickAsync("[data-command=hold]");
        await tab.WaitForTextAsync("answer", "The token is wrong.");
        await tab.WaitAsync("!document.getElementById('token-form').hidden");

        Assert.Equal((0, 1), (flight.Page.Counters.Commands, flight.Page.Counters.CommandsRefused));
        Assert.NotEqual(MissionPhase.Holding, flight.MissionStatus.Phase);
        await tab.WaitForTextAsync("phase", "done");
    }

    [BrowserFact]
    public async Task Reload_InFlight_HasTheWholeFlightAgain()
    {
        await using PageFlight flight = await PageFlight.StartAsync();
        BrowserTab tab = await OpenAsync(flight, 1280, 860);
        await tab.WaitForTextAsync("phase", "searching");
        await tab.WaitAsync("readPath().length > 20");
        double samples = await tab.NumberAsync("readPath().length");
        TimeSpan best = TimeSpan.MaxValue;
        for (int attempt = 0; attempt < Attempts && best >= CompleteWithin; attempt++)
        {
            await tab.ReloadAsync();
            await tab.WaitAsync("typeof readPath === 'function'");
            TimeSpan took = await tab.WaitAsync(
                FormattableString.Invariant($"isComplete && readPath().length >= {samples}"));
            output.WriteLine($"complete {took.TotalMilliseconds:0} ms after the reload");
            best = took < best ? took : best;
        }

        Assert.True(best < CompleteWithin, $"It took {best}.");

        // Scrolled back: an earlier moment on the map, and live again.
        await tab.EvaluateAsync("(() => { const s = document.getElementById('slider'); s.value = 5; s.dispatchEvent(new Event('input')); })()");
        await tab.WaitAsync("!document.getElementById('past').hidden");
        await tab.WaitForTextAsync("past", "m high");
        await tab.ClickAsync("#live");
        await tab.WaitAsync("document.getElementById('past').hidden");
        Assert.Empty(tab.Errors);
    }

    [BrowserFact]
    public async Task Page_ServerRestarts_IsCompleteAgainByItself()
    {
        BrowserTab tab;
        int port;
        await using (PageFlight first = await PageFlight.StartAsync(name: "first"))
        {
            port = first.Page.Address!.Port;
            tab = await OpenAsync(first, 1280, 860);
            await tab.WaitForTextAsync("phase", "searching");
        }

        TimeSpan best = TimeSpan.MaxValue;
        for (int attempt = 0; attempt < Attempts && best >= CompleteWithin; attempt++)
        {
            await tab.WaitForTextAsync("connection", "no connection");
            string name = "second" + attempt.ToString(CultureInfo.InvariantCulture);
            await using PageFlight second = await PageFlight.StartAsync(port: port, name: name);
            TimeSpan took = await tab.WaitAsync(
                $"isComplete && values.get('0/about')?.name === '{name}' "
                    + "&& document.getElementById('connection').textContent === 'live'");
            output.WriteLine($"complete {took.TotalMilliseconds:0} ms after the server was back");
            best = took < best ? took : best;
            await tab.WaitForTextAsync("phase", "searching");
        }

        Assert.True(best < CompleteWithin, $"It took {best}.");
    }

    [BrowserFact]
    public async Task Page_OnAPhone_FitsItsWidth()
    {
        await using PageFlight flight = await PageFlight.StartAsync();
        BrowserTab tab = await OpenAsync(flight, 360, 740, isPhone: true);
        await GiveTokenAsync(tab, PageFlight.Token);
        await tab.WaitForTextAsync("phase", "searching");
        await tab.WaitAsync("document.querySelectorAll('#tracks .track').length >= 1");
        Assert.Equal(360, await tab.NumberAsync("document.documentElement.scrollWidth"));
        await tab.EvaluateAsync("scrollTo(0, 0)");
        await SaveAsync(tab, "live-page-phone.png");
        await tab.ClickAsync("[data-command=hold]");
        await tab.WaitForTextAsync("phase", "holding");
        Assert.Equal(MissionPhase.Holding, flight.MissionStatus.Phase);
        Assert.Empty(tab.Errors);
    }

    [BrowserFact]
    public async Task Page_OfTwoVehicles_ShowsBothAndEachByItself()
    {
        await using PageFlight first = await PageFlight.StartAsync(name: "alpha");
        await using PageFlight second = PageFlight.StartOn(first.Page, "beta");
        BrowserTab tab = await OpenAsync(first, 1280, 860);
        await tab.WaitAsync("document.getElementById('vehicles').options.length === 2");
        await tab.WaitAsync("values.get('1/vehicle')?.lat != null");
        await tab.EvaluateAsync(
            "(() => { const s = document.getElementById('vehicles'); s.selectedIndex = 1; s.dispatchEvent(new Event('change')); })()");
        await tab.WaitAsync("vehicle === 1 && get('about').name === 'beta'");
        await GiveTokenAsync(tab, PageFlight.Token);
        await tab.WaitForTextAsync("phase", "searching");
        await tab.ClickAsync("[data-command=hold]");
        await tab.WaitForTextAsync("phase", "holding");
        Assert.Equal(MissionPhase.Holding, second.MissionStatus.Phase);
        Assert.NotEqual(MissionPhase.Holding, first.MissionStatus.Phase);
        Assert.Empty(tab.Errors);
    }

    private async Task<BrowserTab> OpenAsync(PageFlight flight, int width, int height, bool isPhone = false)
    {
        BrowserTab tab = await chromium.OpenTabAsync();
        await tab.SetSizeAsync(width, height, isPhone);
        await tab.SetColoursAsync(isDark: false);
        await tab.NavigateAsync(flight.Page.Address!);
        await tab.WaitAsync("document.getElementById('connection')?.textContent === 'live'");
        return tab;
    }

    private static async Task GiveTokenAsync(BrowserTab tab, string token)
    {
        await tab.WaitAsync("!document.getElementById('commands').hidden");
        await tab.TypeAsync("#token", token);
        await tab.ClickAsync("#token-form button");
        await tab.WaitAsync("!document.getElementById('buttons').hidden");
    }

    private static async Task<double> NumberOfAsync(BrowserTab tab, string id)
        => double.Parse((await tab.TextAsync(id)).Split(' ')[0], CultureInfo.InvariantCulture);

    private static async Task SaveAsync(BrowserTab tab, string name)
    {
        if (!MakesPictures)
            return;
        string folder = Path.Combine(Repository.Root, "docs", "images");
        Directory.CreateDirectory(folder);
        await File.WriteAllBytesAsync(Path.Combine(folder, name), await tab.CaptureAsync());
    }
}
