using System;

namespace Rabit.Core.Tests.Contracts;

/// <summary>One manager that posts a sample and one that fetches it.</summary>
internal sealed class MessagePair : IDisposable
{
    public MessagePair(TestRun run)
    {
        Run = run;
        Poster = run.Add("poster");
        Fetcher = run.Add("fetcher");
        Publisher = Poster.Publish<Sample>("sample");
        Subscriber = Fetcher.Subscribe<Sample>("sample");
        run.StartAndSettle();
    }

    public TestRun Run { get; }

    public ScriptedManager Poster { get; }

    public ScriptedManager Fetcher { get; }

    public MessagePublisher<Sample> Publisher { get; }

    public MessageSubscriber<Sample> Subscriber { get; }

    public void Dispose() => Run.Dispose();
}
