using System;
using System.Collections.Concurrent;
using System.Diagnostics;
using System.Globalization;
using System.Text.Json;
using System.Threading.Tasks;
using Rabit.Tests.Shared;

namespace Rabit.Uav.Web.Tests.Browser;

/// <summary>A tab: what a person does with it, and what its console says.</summary>
internal sealed class BrowserTab
{
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(90);   // on an idle machine

    private readonly Chromium _browser;
    private readonly string _session;

    public BrowserTab(Chromium browser, string session)
    {
        (_browser, _session) = (browser, session);
        browser.Listen(Take);
    }

    /// <summary>Errors of the console: exceptions, what was refused, what could not be loaded.</summary>
    public ConcurrentQueue<string> Errors { get; } = new();

    public async Task EnableAsync()
    {
        foreach (string domain in new[] { "Page", "Runtime", "Log" })
            await SendAsync(domain + ".enable", new { });
    }

    public Task NavigateAsync(Uri address) => SendAsync("Page.navigate", new { url = address.ToString() });

    public Task ReloadAsync() => SendAsync("Page.reload", new { });

    public Task SetSizeAsync(int width, int height, bool isPhone) => SendAsync(
        "Emulation.setDeviceMetricsOverride", new { width, height, deviceScaleFactor = 1, mobile = isPhone });

    public Task SetColoursAsync(bool isDark) => SendAsync("Emulation.setEmulatedMedia", new
    {
        features = new[] { new { name = "prefers-color-scheme", value = isDark ? "dark" : "light" } },
    });

    /// <summary>PNG of what is visible.</summary>
    public async Task<byte[]> CaptureAsync()
    {
        JsonElement picture = await SendAsync("Page.captureScreenshot", new { format = "png" });
        return picture.GetProperty("data").GetBytesFromBase64();
    }

    public async Task<string> EvaluateAsync(string expression)
    {
        JsonElement answer = await SendAsync(
            "Runtime.evaluate",
            new { expression = $"String({expression})", awaitPromise = true, returnByValue = true });
        return answer.TryGetProperty("exceptionDetails", out JsonElement fault)
            ? throw new InvalidOperationException($"{expression}: {fault}")
            : answer.GetProperty("result").GetProperty("value").GetString()!;
    }

    public async Task<double> NumberAsync(string expression)
        => double.Parse(await EvaluateAsync(expression), CultureInfo.InvariantCulture);

    public Task<string> TextAsync(string id) => EvaluateAsync($"document.getElementById('{id}').textContent");

    /// <summary>
    /// Presses the middle of an element with the mouse, as a person does; again where the page moved it away meanwhile.
    /// </summary>
    public async Task ClickAsync(string selector)
    {
        await EvaluateAsync(
            "(() => { window.isHit = false; document.addEventListener('click', "
                + $"e => {{ if (e.target.closest(\"{selector}\")) window.isHit = true; }}, true); }})()");
        for (int attempt = 0; attempt < 10; attempt++)
        {
            await PressAsync(selector);
            if (await EvaluateAsync("window.isHit") == "true")
                return;
        }

        throw new InvalidOperationException($"The mouse does not hit {selector}.");
    }

    private async Task PressAsync(string selector)
    {
        string place = await EvaluateAsync(
            $"(() => {{ const e = document.querySelector(\"{selector}\"); e.scrollIntoView({{ block: 'center', behavior: 'instant' }}); "
                + "const r = e.getBoundingClientRect(); return (r.x + r.width / 2) + ' ' + (r.y + r.height / 2); })()");
        string[] parts = place.Split(' ');
        double x = double.Parse(parts[0], CultureInfo.InvariantCulture);
        double y = double.Parse(parts[1], CultureInfo.InvariantCulture);
        foreach (string type in new[] { "mousePressed", "mouseReleased" })
            await SendAsync("Input.dispatchMouseEvent", new { type, x, y, button = "left", clickCount = 1 });
    }

    public async Task TypeAsync(string selector, string text)
    {
        await ClickAsync(selector);
        await SendAsync("Input.insertText", new { text });
    }

    /// <summary>Waits until an expression is true.</summary>
    /// <returns>How long it took.</returns>
    public async Task<TimeSpan> WaitAsync(string expression)
    {
        var clock = Stopwatch.StartNew();
        var timeout = new TestTimeout(MaxWait);
        while (await EvaluateAsync($"!!({expression})") != "true")
        {
            if (!await timeout.TryWaitAsync())
                throw new TimeoutException(
                    $"It never comes true: {expression}; console: {string.Join("; ", Errors)}");
        }

        return clock.Elapsed;
    }

    public Task<TimeSpan> WaitForTextAsync(string id, string text)
        => WaitAsync($"document.getElementById('{id}')?.textContent.includes('{text}')");

    private Task<JsonElement> SendAsync(string method, object parameters)
        => _browser.SendAsync(_session, method, parameters);

    private void Take(string session, string method, JsonElement parameters)
    {
        if (session != _session)
            return;
        if (method == "Runtime.exceptionThrown")
            Errors.Enqueue(parameters.GetProperty("exceptionDetails").ToString());
        else if (method == "Log.entryAdded"
            && parameters.GetProperty("entry").GetProperty("level").GetString() == "error")
            Errors.Enqueue(parameters.GetProperty("entry").ToString());
        else if (method == "Runtime.consoleAPICalled" && parameters.GetProperty("type").GetString() == "error")
            Errors.Enqueue(parameters.GetProperty("args").ToString());
    }
}
